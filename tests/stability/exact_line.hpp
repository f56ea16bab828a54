#pragma once
// A line's crossings with a solid in 113 bits, found in another way than the kernels': where the faces' polynomials
// vanish, and between two such places the point is asked whether it is inside.

#include "tests/support/exact.hpp"

#include <algorithm>
#include <vector>

namespace rayscope::test {

/// c[0] + c[1] t + …
using Polynomial = std::vector<Wide>;

[[nodiscard]] inline Wide value_at(const Polynomial& c, Wide t) {
    Wide value = 0;
    for (std::size_t i = c.size(); i-- > 0;) value = value * t + c[i];
    return value;
}

/// Its places of changing sign in [low, high], ascending: between those of its derivative it is monotonous.
[[nodiscard]] inline std::vector<Wide> roots_of(const Polynomial& c, Wide low, Wide high) {
    std::vector<Wide> roots;
    if (c.size() < 2) return roots;
    Polynomial slope;
    for (std::size_t i = 1; i < c.size(); ++i) slope.push_back(Wide(int(i)) * c[i]);
    std::vector<Wide> ends = roots_of(slope, low, high);
    ends.push_back(high);
    for (Wide from = low; const Wide to : ends) {
        const bool rises = value_at(c, from) < 0;
        if (rises != (value_at(c, to) < 0)) {
            Wide a = from, b = to, t = (a + b) / 2;
            for (int i = 0; i < 300 && a < b; ++i) { // Newton's steps, halving where they leave the bracket
                const Wide v = value_at(c, t);
                if (v == 0) break;
                ((v < 0) == rises ? a : b) = t;
                Wide next = t - v / value_at(slope, t);
                if (!(a < next && next < b)) next = (a + b) / 2;
                const Wide step = next < t ? t - next : next - t, size = t < 0 ? -t : t;
                t = next;
                if (step <= size * Wide(0x1p-108)) break;
            }
            roots.push_back(t);
        }
        from = to;
    }
    return roots;
}

/// By its two solutions: where the derivative's only zero shows that there is none, nothing else is asked.
[[nodiscard]] inline std::vector<Wide> roots_of_quadratic(Wide a, Wide b, Wide c) { // a t² + 2 b t + c
    if (a == 0) return b == 0 ? std::vector<Wide>{} : std::vector<Wide>{-c / (2 * b)};
    const Wide d = b * b - a * c;
    if (!(d > 0)) return {};
    const Wide q = b > 0 ? -(b + sqrt(d)) : sqrt(d) - b;
    if (q == 0) return {Wide(0)};
    return {q / a, c / q};
}

struct ExactCrossing {
    Wide t;
    int face;
    bool entering;
};

/// Of a solid generic, ascending; the ray in its object space.
[[nodiscard]] inline std::vector<ExactCrossing> exact_crossings(const Generic<double>& shape, WideRay ray) {
    // About the line's point next to the centre nothing is large.
    const auto dot = [](const WideVec& a, const WideVec& b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    const Wide dd = dot(ray.direction, ray.direction);
    const Wide start = -dot(ray.origin, ray.direction) / dd;
    ray.origin = ray.at(start);
    const auto& [ox, oy, oz] = ray.origin;
    const auto& [dx, dy, dz] = ray.direction;
    std::vector<std::pair<Wide, int>> places;
    const auto add = [&](int face, const std::vector<Wide>& roots) {
        for (const Wide root : roots) places.emplace_back(root, face);
    };
    const auto flat = [&](int face, std::size_t axis, Wide at) {
        if (ray.direction[axis] != 0) add(face, {(at - ray.origin[axis]) / ray.direction[axis]});
    };
    const auto round = [&](Wide w, Wide dw, Wide radius_squared) { // x² + y² − w² − r²
        add(0, roots_of_quadratic(dx * dx + dy * dy - dw * dw, ox * dx + oy * dy - w * dw,
                                  ox * ox + oy * oy - w * w - radius_squared));
    };
    if (const auto* sphere = std::get_if<Sphere<double>>(&shape)) {
        const Wide r = Wide(sphere->radius);
        add(0, roots_of_quadratic(dd, dot(ray.origin, ray.direction), dot(ray.origin, ray.origin) - r * r));
    } else if (std::holds_alternative<Plane<double>>(shape)) {
        flat(0, 2, 0);
    } else if (std::holds_alternative<Cube<double>>(shape)) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const int side : {0, 1}) flat(int(2 * axis) + side, axis, 2 * side - 1);
    } else if (const auto* torus = std::get_if<Torus<double>>(&shape)) {
        const Wide r = Wide(torus->minor), k0 = dot(ray.origin, ray.origin) + 1 - r * r,
                   k1 = 2 * dot(ray.origin, ray.direction);
        const Wide a = dx * dx + dy * dy, b = ox * dx + oy * dy, c = ox * ox + oy * oy;
        const Wide reach = (1 + r + Wide(0x1p-20)) / sqrt(dd); // in t, from the point next to the centre
        if (dot(ray.origin, ray.origin) <= (1 + r) * (1 + r))
            add(0, roots_of({k0 * k0 - 4 * c, 2 * k0 * k1 - 8 * b, k1 * k1 + 2 * k0 * dd - 4 * a, 2 * k1 * dd,
                             dd * dd},
                            -reach, reach));
    } else {
        flat(1, 2, -1);
        flat(2, 2, 1);
        if (const auto* cone = std::get_if<Cone<double>>(&shape)) {
            const Wide mean = (1 + Wide(cone->top)) / 2, slope = (1 - Wide(cone->top)) / 2;
            round(mean - slope * oz, -slope * dz, 0);
        } else {
            round(0, 0, 1);
        }
    }
    std::sort(places.begin(), places.end());
    std::vector<ExactCrossing> found;
    if (places.empty()) return found;
    const Wide beyond = 1 / sqrt(dd);
    // Not asked in the middle: there, by symmetry, a line may touch what it does not cross.
    bool inside = exactly_inside(shape, ray.at(places.front().first - beyond));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Wide here = places[i].first,
                   next = i + 1 < places.size() ? places[i + 1].first : here + 2 * beyond;
        const bool then = exactly_inside(shape, ray.at((5 * here + 3 * next) / 8));
        if (then != inside) found.push_back({here + start, places[i].second, then});
        inside = then;
    }
    return found;
}

} // namespace rayscope::test
