#include "rx.hpp"
using namespace rx;

Spans cylinder(const Ray& r) {
    const dvec2 o(r.o), d(r.d);
    Span tube{-INF, INF}, slab{-INF, INF};
    const double a = dot(d, d);
    if (a == 0) {
        if (dot(o, o) >= 1) return {};
    } else {
        const double middle = -dot(o, d) / a;
        const dvec2 nearest = o + middle * d;
        const double inside = 1 - dot(nearest, nearest);
        if (inside <= 0) return {};
        tube = {middle - std::sqrt(inside / a), middle + std::sqrt(inside / a)};
    }
    if (r.d.z == 0) {
        if (std::abs(r.o.z) > 1) return {};
    } else {
        const double down = (-1 - r.o.z) / r.d.z, up = (1 - r.o.z) / r.d.z;
        slab = {std::min(down, up), std::max(down, up)};
    }
    const Span both{std::max(tube.a, slab.a), std::min(tube.b, slab.b)};
    return both.a < both.b ? Spans{both} : Spans{};
}
