#pragma once
// Rays that are no hard case for anybody.

#include "core/generics/generic.hpp"
#include "core/math/transform.hpp"

#include <random>
#include <vector>

namespace rayscope::bench {

/// Numbers in [-1, 1) from the engine's bits alone: std's distributions differ between libraries.
class Random {
public:
    [[nodiscard]] double next() { return double(std::int32_t(engine_())) * 0x1p-31; }
    [[nodiscard]] Vec3d point() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }

private:
    std::mt19937 engine_{1};
};

/// Rounded to float: the same numbers in every type.
[[nodiscard]] inline Vec3d shared(const Vec3d& v) { return as<double>(as<float>(v)); }

/// Rays from outside, 3 to 6 away, to a point of the shape that lies well inside it (of a surface: well within the unit
/// square around the origin of its plane). Every one of them hits, and grazes nothing on the way to its first hit. In the
/// world, where the shape is put by the matrix; no coordinate has more digits than a float.
[[nodiscard]] inline std::vector<Ray<double>> easy_rays(const Generic<double>& shape, const Mat4d& matrix,
                                                        std::size_t count) {
    Random random;
    std::vector<Ray<double>> list;
    while (list.size() < count) {
        Vec3d from = (4.5 + 1.5 * random.next()) * normalized(random.point());
        Vec3d to = 0.9 * random.point();
        if (!is_solid(shape)) {
            to.z = 0;
            from.z = magnitude(from.z) + 1;
        } else if (implicit_value(shape, to) > -0.1 || implicit_value(shape, from) < 0.5) {
            continue;
        }
        const Vec3d origin = shared(Vec3d(matrix * glm::dvec4(from, 1)));
        const Vec3d target = Vec3d(matrix * glm::dvec4(to, 1));
        list.push_back({origin, shared(normalized(target - origin))});
    }
    return list;
}

} // namespace rayscope::bench
