// Guards against NaN, lost crossings and second meanings of zero: −0.0, denormals, huge and tiny directions, rays along
// axes and in the planes of faces.

#include "tests/stability/draw_case.hpp"
#include "tests/stability/ends.hpp"
#include "tests/stability/property.hpp"
#include "tests/support/scenes.hpp"

namespace rayscope::test {
namespace {

constexpr double denormal = 0x1p-1074;

// Few numbers, so that they meet: on faces, on axes, at rims, at apexes.
double odd_coordinate(Random& random) {
    static const std::vector<double> numbers{0.0,  -0.0, 1.0,      -1.0,      0.5,     -0.5, 0.25,
                                             0.75, 2.0,  denormal, -denormal, 0x1p-30, 3.0,  -5.0};
    return random.below(3) == 0 ? random.uniform(-2, 2) : numbers[std::size_t(random.below(14))];
}

Vec3d odd_vector(Random& random) {
    return {odd_coordinate(random), odd_coordinate(random), odd_coordinate(random)};
}

// Those that keep a ray's zeros, and one of the others.
Mat4d odd_matrix(Random& random) {
    switch (random.below(4)) {
    case 0: return Mat4d{1};
    case 1: return scaling(-1, 1, 0.5);
    case 2: return translation({1, -2, 0.5}) * scaling(0x1p20);
    default: return draw_matrix(random);
    }
}

Case draw_odd(const Generic<double>& shape, Random& random) {
    Case c{shape, odd_matrix(random), {}};
    Vec3d direction = odd_vector(random);
    if (length(direction) < 0.1) direction.y = 1;
    c.ray = {transformed_point(c.matrix, odd_vector(random)), transformed_vector(c.matrix, direction)};
    return c;
}

Solid<double> solid_of(const Case& c) { return placed(c.shape, c.matrix); }

std::vector<End> list_of(const Solid<double>& solid, const Ray<double>& ray) {
    return ends_of(solid, ray, solid.intervals(ray));
}

Verdict judge_order(const Case& c) {
    const auto ends = list_of(solid_of(c), c.ray);
    for (std::size_t i = 0; i < ends.size(); ++i) {
        if (std::isnan(ends[i].t) || std::isnan(ends[i].bound)) return {"not a number:" + text_of(ends)};
        // Two intervals may touch; the ends of one are apart, but for a surface without volume.
        const bool may_meet = i % 2 == 0 || !is_solid(c.shape);
        if (i > 0 && !(may_meet ? ends[i - 1].t <= ends[i].t : ends[i - 1].t < ends[i].t))
            return {"not ascending:" + text_of(ends)};
    }
    return {};
}

Verdict judge_sign_of_zero(const Case& c) {
    const Solid<double> solid = solid_of(c);
    const auto expected = list_of(solid, c.ray);
    bool any = false;
    for (int chosen = 1; chosen < 64; ++chosen) {
        Ray<double> ray = c.ray;
        for (int i = 0; i < 6; ++i) {
            double& x = i < 3 ? ray.origin[i] : ray.direction[i - 3];
            if ((chosen >> i & 1) == 0 || x != 0) continue;
            x = std::signbit(x) ? 0.0 : -0.0;
            any = true;
        }
        const auto ends = list_of(solid, ray);
        bool same = ends.size() == expected.size();
        for (std::size_t i = 0; same && i < ends.size(); ++i) same = ends[i].t == expected[i].t;
        if (!same) return {"zeros of another sign:" + text_of(ends) + " instead of" + text_of(expected)};
    }
    return {"", any};
}

// So small a component turns the direction by less than 10⁻³⁰⁰.
Verdict judge_denormal(const Case& c) {
    if (!is_solid(c.shape) || runs_in_a_face(c)) return {"", false};
    const Solid<double> solid = solid_of(c);
    Ray<double> tilted = c.ray;
    for (int i = 0; i < 3; ++i)
        if (tilted.direction[i] == 0) tilted.direction[i] = std::copysign(denormal, tilted.direction[i]);
    const Verdict verdict = compared(list_of(solid, tilted), list_of(solid, c.ray));
    return {verdict.wrong, verdict.decided && tilted.direction != c.ray.direction};
}

Verdict judge_exact(const Case& c) {
    if (!is_solid(c.shape) || runs_in_a_face(c)) return {"", false};
    const Solid<double> solid = solid_of(c);
    const auto list = list_of(solid, c.ray), expected = exact_ends(c, solid);
    // A line that never crosses its face may be inside a half space all the way.
    if (std::holds_alternative<Plane<double>>(c.shape) && expected.empty() &&
        exactly_inside(c.shape, exact_object_ray(c.matrix, c.ray).origin))
        return compared(list, {{-infinity<double>, 0}, {infinity<double>, 0}});
    return compared(list, expected);
}

template <typename Judge>
void expect_of_odd(const std::vector<Generic<double>>& shapes, int cases, double least, const Judge& judge) {
    for (const Generic<double>& shape : shapes)
        expect_of_cases(
            generic_name(shape), cases, least, [&](Random& random) { return draw_odd(shape, random); },
            judge);
}

void expect_order(int n) { expect_of_odd(all_generics(), n, 1, judge_order); }
void expect_no_sign(int n) { expect_of_odd(all_generics(), n, 0.3, judge_sign_of_zero); }
void expect_no_denormals(int n) { expect_of_odd(solid_generics(), n, 0.2, judge_denormal); }
void expect_exact(int n) { expect_of_odd(solid_generics(), n, 0.5, judge_exact); }

TEST(OddNumbers, give_ascending_numbers) { expect_order(samples(2000)); }
TEST(OddNumbersFull, give_ascending_numbers) { expect_order(samples(500000)); }
TEST(OddNumbers, zero_has_no_sign) { expect_no_sign(samples(1000)); }
TEST(OddNumbersFull, zero_has_no_sign) { expect_no_sign(samples(50000)); }
TEST(OddNumbers, a_denormal_component_is_none) { expect_no_denormals(samples(2000)); }
TEST(OddNumbersFull, a_denormal_component_is_none) { expect_no_denormals(samples(200000)); }
TEST(OddNumbers, agree_with_113_bits) { expect_exact(samples(2000)); }
TEST(OddNumbersFull, agree_with_113_bits) { expect_exact(samples(200000)); }

} // namespace
} // namespace rayscope::test
