// Guards against normals that are turned inward, or bent by a matrix that scales its axes unevenly: for tiny, huge and
// sheared solids.

#include "tests/stability/draw_case.hpp"
#include "tests/stability/property.hpp"
#include "tests/support/exact.hpp"

namespace rayscope::test {
namespace {

// The gradient of the face's polynomial, up to a positive factor.
WideVec exact_gradient(const Generic<double>& shape, int face, const WideVec& p) {
    const auto& [x, y, z] = p;
    const auto along = [](std::size_t axis, int sign) {
        WideVec n{};
        n[axis] = sign;
        return n;
    };
    if (std::holds_alternative<Sphere<double>>(shape)) return p;
    if (std::holds_alternative<Plane<double>>(shape)) return along(2, 1);
    if (std::holds_alternative<Cube<double>>(shape))
        return along(std::size_t(face / 2), face % 2 == 0 ? -1 : 1);
    if (const auto* torus = std::get_if<Torus<double>>(&shape)) {
        const Wide r = Wide(torus->minor), k = x * x + y * y + z * z + 1 - r * r;
        return {(k - 2) * x, (k - 2) * y, k * z};
    }
    if (face != 0) return along(2, face == 1 ? -1 : 1);
    if (std::holds_alternative<Cylinder<double>>(shape)) return {x, y, 0};
    const Wide top = Wide(std::get<Cone<double>>(shape).top), slope = (1 - top) / 2;
    return {x, y, slope * ((1 + top) / 2 - slope * z)};
}

Wide absolute_of(Wide a) { return a < 0 ? -a : a; }

// Rows of M⁻¹.
std::array<WideVec, 3> exact_inverse(const Mat4d& matrix) {
    std::array<WideVec, 3> inverse;
    Mat4d linear = matrix;
    linear[3] = {0, 0, 0, 1};
    for (int axis = 0; axis < 3; ++axis) {
        Vec3d e{0};
        e[axis] = 1;
        const WideVec column = exact_object_ray(linear, {Vec3d{0}, e}).direction;
        for (std::size_t i = 0; i < 3; ++i) inverse[i][std::size_t(axis)] = column[i];
    }
    return inverse;
}

// How much a unit of the object-space point's error turns the normal, before the matrix: the form's second derivative.
double bend(const Generic<double>& shape, int face) {
    if (face != 0 || std::holds_alternative<Plane<double>>(shape) ||
        std::holds_alternative<Cube<double>>(shape))
        return 0;
    const auto* torus = std::get_if<Torus<double>>(&shape);
    return torus != nullptr ? 1 + 1 / (1 - torus->minor) : 1; // of (distance from the core circle)² / 2
}

// The kernel's object point is off by e, its normal there by |H| e and a few roundings; M⁻ᵀ, each element rounded, makes
// of that at most |M⁻ᵀ| (|H| e + 8ε |n|), seen from the length of M⁻ᵀ n.
double angle_bound(const Solid<double>& solid, const Case& c, double t, int face,
                   const std::array<WideVec, 3>& inverse) {
    const Vec3d p = solid.transform.to_object(c.ray).at(t);
    const Vec3d n = std::visit([&](const auto& s) { return s.normal(p, face); }, solid.shape);
    const Vec3d point_error = 4 * epsilon<double> * solid.transform.point_error(c.ray, t);
    const Vec3d off = bend(c.shape, face) * Vec3d{length(point_error)} + 8 * epsilon<double> * absolute(n);
    Vec3d spread{0}, moved{0};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Wide element = inverse[std::size_t(i)][std::size_t(j)];
            spread[j] += double(absolute_of(element)) * off[i];
            moved[j] += double(element) * n[i];
        }
    return length(spread) / length(moved) + 4 * epsilon<double>;
}

Verdict judge_normals(const Case& c) {
    if (!is_solid(c.shape)) return {"", false};
    const Solid<double> solid = placed(c.shape, c.matrix);
    const auto inverse = exact_inverse(c.matrix);
    const WideRay exact = exact_object_ray(c.matrix, c.ray);
    bool decided = false;
    for (const Interval<double>& span : solid.intervals(c.ray))
        for (const bool entering : {true, false}) {
            const double t = entering ? span.enter : span.exit;
            const int face = entering ? span.enter_face : span.exit_face;
            if (!std::isfinite(t)) continue;
            const Vec3d normal = solid.normal(c.ray, t, face);
            const std::string what =
                " at " + hex(t) + " on face " + std::to_string(face) + ": " + hex(normal);
            if (!(std::abs(length(normal) - 1) <= 4 * epsilon<double>)) return {"not unit" + what};
            const double allowed = angle_bound(solid, c, t, face, inverse);
            if (!(allowed < 0.1)) continue; // at an apex, or where nothing is left of the digits
            decided = true;
            const WideVec gradient = exact_gradient(c.shape, face, exact.at(Wide(t)));
            WideVec truth{};
            for (std::size_t j = 0; j < 3; ++j)
                for (std::size_t i = 0; i < 3; ++i) truth[j] += inverse[i][j] * gradient[i];
            const Wide size = sqrt(truth[0] * truth[0] + truth[1] * truth[1] + truth[2] * truth[2]);
            Wide apart = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                const Wide difference = truth[j] / size - Wide(normal[int(j)]);
                apart += difference * difference;
            }
            if (!(double(sqrt(apart)) <= allowed))
                return {"off by " + hex(double(sqrt(apart))) + ", allowed " + hex(allowed) + what};
            const double slope = dot(normal, normalized(c.ray.direction));
            const double known = allowed + 4 * epsilon<double>;
            if (std::abs(slope) > known && (slope < 0) != entering &&
                2 * solid.error_bound(c.ray, t, face) < span.exit - span.enter)
                return {"turned inward" + what};
        }
    return {"", decided};
}

// Condition up to 10⁸.
Case draw_distorted(const Generic<double>& shape, Random& random) {
    Case c = draw_case(shape, random);
    const Mat4d distorted = c.matrix * random_rotation(random) *
                            scaling(random.decade(-4, 4), random.decade(-4, 4), random.decade(-4, 4));
    const Ray<double> ray = draw_object_ray(random);
    c.matrix = distorted;
    c.ray = {transformed_point(distorted, ray.origin), transformed_vector(distorted, ray.direction)};
    return c;
}

void expect_normals(int cases) {
    for (const Generic<double>& shape : solid_generics())
        expect_of_cases(
            generic_name(shape), cases, 0.1,
            [&](Random& random) {
                return random.coin() ? draw_case(shape, random) : draw_distorted(shape, random);
            },
            judge_normals);
}

TEST(Normals, are_unit_and_outward_whatever_the_matrix) { expect_normals(samples(3000)); }
TEST(NormalsFull, are_unit_and_outward_whatever_the_matrix) { expect_normals(samples(300000)); }

} // namespace
} // namespace rayscope::test
