#pragma once
// Scene files as text, for show() of an exercise.

#include "rx.hpp"

#include <cstdio>

namespace rx {

/// As many digits as bring the number back.
inline std::string digits(double number) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", number);
    return text;
}
inline std::string list(const dvec3& v) {
    return "[" + digits(v.x) + ", " + digits(v.y) + ", " + digits(v.z) + "]";
}

/// A step of `transform`.
inline std::string matrix_step(const dmat4& m) {
    std::string text = "{ matrix = [";
    for (int row = 0; row < 3; ++row) {
        text += "[";
        for (int column = 0; column < 4; ++column)
            text += digits(m[column][row]) + (column < 3 ? ", " : "], ");
    }
    return text + "[0, 0, 0, 1]] }";
}

/// A generic shape of matt material, moved by m.
inline std::string generic(const std::string& name, const std::string& shape, const dmat4& m = dmat4(1),
                           const std::string& material = "matt") {
    return "\n[generics." + name + "]\nshape = \"" + shape + "\"\nmaterial = \"" + material +
           "\"\ntransform = [" + matrix_step(m) + "]\n";
}

/// Moves the origin to p and the z axis to n: of a plane's matrix.
inline dmat4 facing(const dvec3& p, const dvec3& n) {
    const dvec3 x = glm::normalize(cross(std::abs(n.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), n));
    return dmat4(dvec4(x, 0), dvec4(cross(n, x), 0), dvec4(n, 0), dvec4(p, 1));
}

/// The matrix of a cube that stands across the ray from t = a to b.
inline dmat4 across(const Ray& r, double a, double b) {
    const double length = std::sqrt(dot(r.d, r.d));
    return glm::scale(facing(r.o + (a + b) / 2 * r.d, r.d / length), dvec3(2, 2, (b - a) / 2 * length));
}

/// Where the ray is inside, as solids: name1, name2, … They are clear, so that it goes through.
inline std::string solids(const std::string& name, const Ray& r, const Spans& spans, int priority = 0) {
    const dvec3 d = glm::normalize(r.d);
    std::string text;
    int number = 0;
    for (const Span& span : spans) {
        const std::string own = name + std::to_string(++number);
        if (span.a > -INF && span.b < INF)
            text += generic(own, "cube", across(r, span.a, span.b), "clear");
        else if (span.b < INF)
            text += generic(own, "plane", facing(r.o + span.b * r.d, d), "clear");
        else if (span.a > -INF)
            text += generic(own, "plane", facing(r.o + span.a * r.d, -d), "clear");
        else
            text += generic(own + "_half", "plane") + "\n[compounds." + own + "]\nis = \"" + own +
                    "_half | !" + own + "_half\"\nmaterial = \"clear\"\n";
        text += "priority = " + std::to_string(priority) + "\n";
    }
    return text;
}

/// What was answered, as solids answer1, answer2, … A ray comes to them before it comes to what they are equal to.
inline std::string answer_solids(const Ray& r, Spans spans) {
    constexpr double a_little = 1e-9;
    for (Span& span : spans) {
        span.a -= a_little * (1 + std::abs(span.a));
        span.b += a_little * (1 + std::abs(span.b));
    }
    return solids("answer", r, spans, 1);
}

/// A scene file: camera, lamp, the materials matt, mirror, glass and clear, and what is given.
inline std::string scene(const std::string& objects, const dvec3& eye = {4, 3, 6},
                         const dvec3& at = dvec3(0)) {
    return "[camera]\neye = " + list(eye) + "\nlook_at = " + list(at) +
           "\nfield_of_view = 40\n\n[lights.lamp]\nposition = [4, 5, 6]\n"
           "\n[materials.matt]\nambient = [0.1, 0.05, 0.03]\ndiffuse = [0.8, 0.4, 0.2]\n"
           "\n[materials.mirror]\ndiffuse = 0.2\nreflection = 0.7\n"
           "\n[materials.glass]\ndiffuse = 0.1\ntransmission = 0.8\nindex = 1.5\n"
           "\n[materials.clear]\ndiffuse = 0.1\ntransmission = 1\n" +
           objects;
}

} // namespace rx
