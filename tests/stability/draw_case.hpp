#pragma once
// Cases by chance, and hard ones more often than chance would have it.

#include "tests/stability/cases.hpp"
#include "tests/support/matrices.hpp"

namespace rayscope::test {

/// Of sizes from 10⁻⁶ to 10⁶, up to 10⁶ sizes away, turned, mirrored, every other one distorted.
[[nodiscard]] inline Mat4d draw_matrix(Random& random) {
    const double size = random.decade(-6, 6);
    Mat4d m = scaling(random.coin() ? size : -size);
    if (random.coin())
        m = m * shearing(random.uniform(-2, 2)) *
            scaling(random.decade(-1, 1), random.decade(-1, 1), random.decade(-1, 1));
    if (random.below(4) != 0) m = random_rotation(random) * m;
    if (random.below(4) != 0) m = translation(random.in_cube(size * random.decade(-2, 6))) * m;
    return m;
}

/// A ray that is likely to meet the shape, from inside or up to 10⁹ sizes away; every fourth along axes.
[[nodiscard]] inline Ray<double> draw_object_ray(Random& random) {
    const int kind = random.below(4);
    Ray<double> ray = random.towards_unit_cube(kind == 0 ? 0.5 : kind == 1 ? 4 : random.decade(0, 9));
    if (random.below(4) == 0)
        for (int axis = 0; axis < 3; ++axis)
            if (random.coin()) ray.direction[axis] = 0;
    if (ray.direction == Vec3d{0}) ray.direction.z = 1;
    return ray;
}

[[nodiscard]] inline Case draw_case(const Generic<double>& shape, Random& random) {
    Case c;
    c.shape = shape;
    c.matrix = draw_matrix(random);
    const Ray<double> ray = draw_object_ray(random);
    c.ray = {transformed_point(c.matrix, ray.origin),
             normalized(transformed_vector(c.matrix, ray.direction))};
    c.next = random.direction();
    c.slope = random.decade(-9, 1) * (random.coin() ? -1 : 1);
    if (random.coin()) {
        c.wall = random.direction();
        c.gap = random.decade(0, 6);
    }
    return c;
}

} // namespace rayscope::test
