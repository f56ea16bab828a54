#include "rx.hpp"
using namespace rx;

Spans sphere(const Ray& r) {
    const double a = dot(r.d, r.d), b = dot(r.o, r.d);
    // The point nearest to the centre decides: b² − ac would cancel far away.
    const dvec3 nearest = r.o - b / a * r.d;
    const double inside = 1 - dot(nearest, nearest);
    if (inside <= 0) return {};
    const double half = std::sqrt(inside / a);
    return {{-b / a - half, -b / a + half}};
}
