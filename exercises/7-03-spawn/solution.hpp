#include "rx.hpp"
using namespace rx;

dvec3 spawn(dvec3 p, dvec3 err, dvec3 n, dvec3 d) {
    const double bound = dot(glm::abs(n), err);
    const dvec3 shift = (dot(d, n) < 0 ? -bound : bound) * n;
    dvec3 start = p + shift;
    for (int i = 0; i < 3; ++i) {
        if (shift[i] > 0) start[i] = std::nextafter(start[i], INF);
        if (shift[i] < 0) start[i] = std::nextafter(start[i], -INF);
    }
    return start;
}
