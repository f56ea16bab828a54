#include "cases.hpp"

namespace {

/// Leaves on the side of n (1) or on the other (-1).
dvec3 leaving(Cases& c, const dvec3& n, double side, double cosine) {
    return std::sqrt(1 - cosine * cosine) * c.across(n) + side * cosine * n;
}
dvec3 bound(Cases& c, double size) { return size * c.vector(0.6, 1); }
dvec3 axis(Cases& c) {
    dvec3 n(0);
    n[c.whole(0, 2)] = c.sign();
    return n;
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 3; ++i) {
        const dvec3 n = c.unit();
        c.add("a reflected ray", c.vector(-3, 3), bound(c, 1e-5), n, leaving(c, n, 1, c.between(0.4, 0.9)));
    }
    c.group("edge");
    for (int i = 0; i < 2; ++i) {
        const dvec3 n = c.unit();
        c.add("a refracted ray", c.vector(-3, 3), bound(c, 1e-5), n, leaving(c, n, -1, c.between(0.4, 0.9)));
    }
    const dvec3 n = axis(c);
    c.add("grazing, d·n = 1e-13", c.vector(-3, 3), bound(c, 1e-5), n, leaving(c, n, 1, 1e-13));
    c.add("grazing, d·n = -1e-13", c.vector(-3, 3), bound(c, 1e-5), n, leaving(c, n, -1, 1e-13));
    c.group("hard");
    for (const double side : {1.0, -1.0}) {
        const dvec3 far(1e13 * c.vector(0.2, 0.8) * dvec3(c.sign(), c.sign(), c.sign()));
        const dvec3 m = axis(c);
        // Less than half the distance of neighbouring numbers there.
        c.add("|p| = 1e13", far, dvec3(1e-4), m, leaving(c, m, side, c.between(0.4, 0.9)));
        c.add("|p| = 1e13, slanted", far, dvec3(1e-3), c.unit(), c.unit());
        c.add("|p| = 1e-6, between thin walls", 1e-6 * c.unit(), bound(c, 1e-13), m,
              leaving(c, m, side, c.between(0.4, 0.9)));
    }
}

/// Empty if the point is one that the task allows.
std::string judge(const dvec3& p, const dvec3& err, const dvec3& n, const dvec3& d, const dvec3& start) {
    const long double side = dot(d, n) < 0 ? -1 : 1;
    long double least = 0, shift = 0, room = 0;
    std::array<long double, 3> off{};
    for (int i = 0; i < 3; ++i) {
        least += std::abs((long double)n[i]) * err[i];
        off[std::size_t(i)] = (long double)start[i] - p[i];
        shift += side * off[std::size_t(i)] * n[i];
        // A stored number can't be nearer to what is meant than its neighbours are apart. Those of p: the answer must not
        // make its own room.
        room += 2 * (std::nextafter(std::abs(p[i]), INF) - std::abs(p[i]));
    }
    if (!(shift == shift)) return "the point is no number";
    if (shift < least * (1 - 1e-9L))
        return "the shift along n is " + digits(double(shift)) + ", at least " + digits(double(least)) +
               " is needed";
    if (shift > 100 * least + room)
        return "the shift along n is " + digits(double(shift)) + ", at most " + digits(double(100 * least)) +
               " is allowed";
    for (int i = 0; i < 3; ++i) {
        const long double across = off[std::size_t(i)] - side * shift * n[i];
        if (std::abs(across) > least + room)
            return "the point is shifted across n, by " + digits(double(across));
    }
    return "";
}

/// The surface, seen from the start of the ray: an answer that lies elsewhere moves it.
Shown show(const dvec3& p, const dvec3&, const dvec3& n, const dvec3& d, const dvec3& right,
           const dvec3& answer) {
    const dvec3 at = p + (right - answer);
    return {scene(generic("surface", "plane", facing(at, n)), at + 4.0 * n + dvec3(1, 2, 3), at), {right, d}};
}
