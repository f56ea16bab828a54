#pragma once
// Two inside lists of one line, compared where rounding within the error bounds can't part them.

#include "tests/stability/cases.hpp"
#include "tests/stability/exact_line.hpp"

namespace rayscope::test {

/// One end of an inside interval; an unbounded one has t = ±inf.
struct End {
    double t;
    double bound;
};

/// Where a ray runs along a face, the bound is no longer small beside the generic's own size, which is about 1: the face
/// may as well be crossed at the other end of the world, or never. As good as infinite, then.
[[nodiscard]] inline End end_of(const Solid<double>& solid, const Ray<double>& ray, double t, int face) {
    if (!std::isfinite(t)) return {t, 0};
    const double speed = length(solid.transform.vector_to_object(ray.direction));
    const double judges = 0x1p-100; // the wide numbers' own rounding
    const double bound = solid.error_bound(ray, t, face) + judges / speed;
    return {t, bound * speed < 0x1p-10 ? bound : infinity<double>};
}

[[nodiscard]] inline std::vector<End> ends_of(const Solid<double>& solid, const Ray<double>& ray,
                                              const Intervals<double>& list) {
    std::vector<End> ends;
    for (const Interval<double>& span : list) {
        ends.push_back(end_of(solid, ray, span.enter, span.enter_face));
        ends.push_back(end_of(solid, ray, span.exit, span.exit_face));
    }
    return ends;
}

[[nodiscard]] inline std::vector<End> exact_ends(const Case& c, const Solid<double>& solid) {
    std::vector<End> ends;
    const auto crossings = exact_crossings(c.shape, exact_object_ray(c.matrix, c.ray));
    if (!crossings.empty() && !crossings.front().entering) ends.push_back({-infinity<double>, 0});
    for (const ExactCrossing& e : crossings) {
        ends.push_back(end_of(solid, c.ray, double(e.t), e.face));
        if (!std::isfinite(ends.back().t)) ends.back().bound = infinity<double>; // beyond all doubles
    }
    if (!crossings.empty() && crossings.back().entering) ends.push_back({infinity<double>, 0});
    return ends;
}

[[nodiscard]] inline std::string text_of(const std::vector<End>& ends) {
    std::string text;
    for (const End& end : ends) text += ' ' + hex(end.t) + " ± " + hex(end.bound);
    return text.empty() ? " nothing" : text;
}

/// Two ends within the sum of their bounds may both be rounding's: a graze is seen or not. (The bounds, too, are computed
/// at places that rounding moves: a graze is one up to twice as far.)
[[nodiscard]] inline bool grazes(const std::vector<End>& ends) {
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (!(ends[i + 1].t - ends[i].t > 2 * (ends[i].bound + ends[i + 1].bound))) return true;
    return false;
}

/// Does the line lie in a face, up to 40 bits? Then it is within or without, as rounding will have it.
[[nodiscard]] inline bool runs_in_a_face(const Case& c) {
    const WideRay ray = exact_object_ray(c.matrix, c.ray);
    Wide size = 0;
    for (const Wide d : ray.direction) size = std::max(size, d < 0 ? -d : d);
    const auto small = [&](int face, Wide t) {
        const Wide value = face_value(c.shape, face, ray.at(t));
        return (value < 0 ? -value : value) < Wide(0x1p-40);
    };
    for (int face = 0; face < faces_of(c.shape); ++face)
        if (small(face, 0) && small(face, 1 / size) && small(face, -1 / size)) return true;
    return false;
}

[[nodiscard]] inline Verdict compared(const std::vector<End>& list, const std::vector<End>& expected) {
    if (grazes(list) || grazes(expected)) return {"", false};
    bool same = list.size() == expected.size();
    for (std::size_t i = 0; same && i < list.size(); ++i)
        same = list[i].t == expected[i].t ||
               std::abs(list[i].t - expected[i].t) <= std::max(list[i].bound, expected[i].bound);
    return {same ? "" : "the ends are" + text_of(list) + " instead of" + text_of(expected)};
}

} // namespace rayscope::test
