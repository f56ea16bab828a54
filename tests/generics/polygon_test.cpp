#include "core/generics/open_tube.hpp"
#include "core/generics/polygon.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rayscope::test {
namespace {

// An L in the plane z = 2: the square [0, 2]² without its upper right quarter.
Polygon<double> ell() {
    return Polygon<double>({{0, 0, 2}, {2, 0, 2}, {2, 1, 2}, {1, 1, 2}, {1, 2, 2}, {0, 2, 2}});
}

TEST(Polygon, a_concave_outline_is_open_where_it_is_notched) {
    for (const double way : {1.0, -1.0}) {
        const auto hits = [&](double x, double y) {
            const auto list = ell().intervals({{x, y, 2 - 3 * way}, {0, 0, way}});
            if (list.count == 1) {
                EXPECT_EQ(list.items[0].enter, 3);
                EXPECT_EQ(list.items[0].exit, 3);
                EXPECT_EQ(list.items[0].enter_face, 0);
            }
            return list.count == 1;
        };
        for (const auto& [x, y] :
             {std::pair{0.5, 0.5}, {1.5, 0.5}, {0.5, 1.5}, {1.9, 0.9}, {0.9, 1.9}, {0.1, 0.1}})
            EXPECT_TRUE(hits(x, y)) << x << ' ' << y;
        for (const auto& [x, y] : {std::pair{1.5, 1.5},
                                   {1.1, 1.1},
                                   {-0.1, 0.5},
                                   {2.1, 0.5},
                                   {0.5, 2.1},
                                   {0.5, -0.1},
                                   {2.5, 1},
                                   {-1.0, 1},
                                   {1.5, -1},
                                   {-1, -1}})
            EXPECT_FALSE(hits(x, y)) << x << ' ' << y;
    }
}

TEST(Polygon, a_ray_in_its_plane_misses_and_one_behind_has_a_negative_t) {
    EXPECT_EQ(ell().intervals({{-1, 0.5, 2}, {1, 0, 0}}).count, 0);
    const auto behind = ell().intervals({{0.5, 0.5, 5}, {0, 0, 1}});
    ASSERT_EQ(behind.count, 1);
    EXPECT_EQ(behind.items[0].enter, -3);
    EXPECT_EQ(ell().intervals({{0.5, 0.5, 2}, {0.1, 0, 1}}, 0).count, 0); // leaving it
}

TEST(Polygon, its_normal_follows_the_order_of_its_corners) {
    EXPECT_EQ(ell().normal({}, 0), (Vec3d{0, 0, 1}));
    EXPECT_EQ((Polygon<double>({{0, 0, 2}, {0, 1, 2}, {1, 0, 2}}).normal({}, 0)), (Vec3d{0, 0, -1}));
    EXPECT_EQ(area_vector<double>({{0, 0, 0}, {2, 0, 0}, {2, 3, 0}, {0, 3, 0}}), (Vec3d{0, 0, 12}));
    EXPECT_EQ(area_vector<double>({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}), Vec3d{0});
}

// Slivers among them: there two edges say next to nothing in doubles.
TEST(Polygon, its_normal_has_all_digits_of_a_double) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(2000)); ++seed) {
        Random random(seed);
        const Vec3d a = random.decade(-3, 6) * random.in_cube(1), along = random.in_cube(1);
        const Vec3d b = a + along;
        const Vec3d c = a + random.uniform(0, 1) * along + random.decade(-9, 0) * random.in_cube(1);
        const Vec3d normal = Polygon<double>({a, b, c}).normal(a, 0);
        const auto wide = [](const Vec3d& v) { return as<Float128>(v); };
        const Vec3<Float128> exact = Polygon<Float128>({wide(a), wide(b), wide(c)}).normal(wide(a), 0);
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_LE(double(magnitude(Float128(normal[axis]) - exact[axis])),
                      epsilon<double> / 2 * std::abs(normal[axis]) + 0x1p-56)
                << "seed " << seed << " axis " << axis;
    }
}

// Squares of such lengths are no numbers any more.
TEST(Polygon, is_hit_at_any_size) {
    for (const double size : {1e-165, 1e-155, 1e-100, 1e100, 1e153, 1e158}) {
        const Polygon<double> square({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
        const auto hits = [&](double x, double y) {
            return square.intervals({{x * size, y * size, size}, {0, 0, -1}}).count == 1;
        };
        for (const auto& [x, y] : {std::pair{0.5, 0.5}, {0.51, 0.3}, {0.02, 0.02}, {0.99, 0.5}})
            EXPECT_TRUE(hits(x, y)) << size << ": " << x << ' ' << y;
        for (const auto& [x, y] : {std::pair{1.01, 0.5}, {-0.01, 0.5}, {1.3, 1.3}, {0.5, 9.0}})
            EXPECT_FALSE(hits(x, y)) << size << ": " << x << ' ' << y;
    }
    constexpr double size = 3e-162;
    const Polygon<double> diamond({{size, 0, 0}, {0, size, 0}, {-size, 0, 0}, {0, -size, 0}});
    EXPECT_EQ(diamond.intervals({{0.51 * size, 0.51 * size, size}, {0, 0, -1}}).count, 0);
    EXPECT_EQ(diamond.intervals({{0.3 * size, 0.3 * size, size}, {0, 0, -1}}).count, 1);
}

// By the even-odd rule the middle of a pentagram lies outside: its edges run around it twice.
TEST(Polygon, a_pentagram_is_open_in_its_middle) {
    std::vector<Vec3d> corners;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2 * 2 * std::numbers::pi * i / 5;
        corners.push_back({std::cos(angle), std::sin(angle), 0});
    }
    const Polygon<double> star(corners);
    EXPECT_EQ(star.intervals({{0, 0, 1}, {0, 0, -1}}).count, 0);
    EXPECT_EQ(star.intervals({{0.3, 0.05, 1}, {0, 0, -1}}).count, 0);
    EXPECT_EQ(star.intervals({{0.8, 0, 1}, {0, 0, -1}}).count, 1);
}

// Whatever is decided without asking the edges is what they say: counted here by the turns of the outline.
TEST(Polygon, a_random_outline_is_hit_where_its_edges_say) {
    int hits = 0, misses = 0;
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
        Random random(seed);
        const Mat4d m =
            translation(random.in_cube(5)) * random_rotation(random) * scaling(random.decade(-3, 3));
        std::vector<Vec3d> flat, corners;
        const int count = 3 + random.below(6);
        const bool regular = random.coin(); // else it crosses itself
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            flat.push_back(regular ? Vec3d{std::cos(angle), std::sin(angle), 0}
                                   : Vec3d{random.uniform(-1, 1), random.uniform(-1, 1), 0});
            corners.push_back(Vec3d(m * glm::dvec4(flat.back(), 1)));
        }
        if (length(area_vector(flat)) < 0.1) continue;
        const Vec3d p{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), 0};
        bool inside = false;
        double nearest = 1;
        for (std::size_t i = 0; i < flat.size(); ++i) {
            const Vec3d a = flat[i] - p, b = flat[(i + 1) % flat.size()] - p;
            const double side = a.x * b.y - a.y * b.x;
            nearest = std::min({nearest, std::abs(side), std::abs(a.y)});
            if ((a.y > 0) != (b.y > 0) && (side > 0) == (b.y > 0)) inside = !inside;
        }
        if (nearest < 1e-6) continue;
        const Vec3d target(m * glm::dvec4(p, 1)), origin = target + random.decade(-2, 4) * random.direction();
        const Ray<double> ray{origin, target - origin};
        const double slope = std::abs(dot(normalized(ray.direction), Vec3d(m * glm::dvec4(0, 0, 1, 0)))) /
                             length(Vec3d(m * glm::dvec4(0, 0, 1, 0)));
        if (slope < 1e-3) continue;
        (inside ? hits : misses) += 1;
        ASSERT_EQ(Polygon<double>(corners).intervals(ray).count == 1, inside) << "seed " << seed << hex(ray);
    }
    EXPECT_GT(hits, samples(2000));
    EXPECT_GT(misses, samples(2000));
}

// Against the signs of three areas, in directions along which each axis is the largest.
TEST(Polygon, a_triangle_is_hit_exactly_where_the_areas_agree) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(5000)); ++seed) {
        Random random(seed);
        const Vec3d a = random.in_cube(2), b = random.in_cube(2), c = random.in_cube(2),
                    origin = random.in_cube(3);
        const double u = random.uniform(-0.5, 1.5), v = random.uniform(-0.5, 1.5), w = 1 - u - v;
        const double edge = std::min({std::abs(u), std::abs(v), std::abs(w)});
        if (edge < 1e-9 || length(cross(b - a, c - a)) < 1e-3) continue;
        const Vec3d target = w * a + u * b + v * c;
        const Polygon<double> triangle({a, b, c});
        const Ray<double> ray{origin, target - origin};
        if (std::abs(dot(triangle.normal({}, 0), normalized(ray.direction))) < 1e-3) continue;
        const auto list = triangle.intervals(ray);
        const std::string what = hex(a) + hex(b) + hex(c) + hex(ray) + " seed " + std::to_string(seed);
        ASSERT_EQ(list.count, u > 0 && v > 0 && w > 0 ? 1 : 0) << what;
        if (list.count == 1) {
            ASSERT_NEAR(list.items[0].enter, 1, 1e-9) << what;
        }
    }
}

// A fan around one corner: rays aimed at points of the inner edges, and at the corner, hit at least one triangle.
TEST(Polygon, nothing_leaks_through_shared_edges) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(20000)); ++seed) {
        Random random(seed);
        const Vec3d a = random.in_cube(1), b = a + random.in_cube(2), left = random.in_cube(2);
        const Vec3d middle = (a + b) / 2.0, right = middle + (middle - left) + 0.2 * random.in_cube(1);
        const Polygon<double> one({a, b, left}), other({b, a, right});
        const Vec3d target = a + random.uniform(0.01, 0.99) * (b - a);
        const Vec3d n = normalized(one.normal({}, 0) + other.normal({}, 0));
        const Vec3d origin = target + (random.coin() ? 3.0 : -3.0) * normalized(n + 0.5 * random.direction());
        if (dot(one.normal({}, 0), other.normal({}, 0)) < 0.5) continue;
        const Ray<double> ray{origin, target - origin};
        ASSERT_GE(one.intervals(ray).count + other.intervals(ray).count, 1)
            << hex(a) << hex(b) << hex(left) << hex(right) << hex(ray) << " seed " << seed;
    }
}

TEST(Polygon, exact_edges_and_corners_of_a_fan_are_hit_once) {
    const std::vector<Vec3d> rim{{1, 0, 0},  {1, 1, 0},   {0, 1, 0},  {-1, 1, 0},
                                 {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}};
    for (const Vec3d& target : {Vec3d{0, 0, 0}, Vec3d{0.5, 0, 0}, Vec3d{0, 0.5, 0}, Vec3d{0.5, 0.5, 0},
                                Vec3d{-0.5, 0, 0}, Vec3d{-0.25, 0.25, 0}, Vec3d{0, -0.5, 0}})
        for (const double way : {1.0, -1.0}) {
            int hits = 0;
            for (std::size_t i = 0; i < rim.size(); ++i)
                hits += Polygon<double>({{0, 0, 0}, rim[i], rim[(i + 1) % rim.size()]})
                            .intervals({target + Vec3d{0, 0, -way}, {0, 0, way}})
                            .count;
            EXPECT_EQ(hits, 1) << hex(target) << way;
        }
}

TEST(Polygon, smooth_normals_are_interpolated_between_the_corners) {
    const Vec3d na{-1, 0, 1}, nb{1, 0, 1}, nc{0, 1, 1}, nd{0, -1, 1};
    const Polygon<double> flat({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    EXPECT_FALSE(flat.smooth());
    EXPECT_EQ(flat.shading_normal({0.2, 0.2, 0}), (Vec3d{0, 0, 1}));
    const Polygon<double> quad({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {na, nb, nc, nd});
    EXPECT_TRUE(quad.smooth());
    const auto expect = [&](const Vec3d& p, const Vec3d& n) {
        EXPECT_NEAR(length(quad.shading_normal(p) - n), 0, 1e-15) << hex(p);
    };
    expect({0, 0, 0}, na);
    expect({1, 0, 0}, nb);
    expect({1, 1, 0}, nc);
    expect({0, 1, 0}, nd);
    expect({0.75, 0.25, 0}, 0.25 * na + 0.5 * nb + 0.25 * nc); // in the first triangle of the fan
    expect({0.25, 0.75, 0}, 0.25 * na + 0.25 * nc + 0.5 * nd); // in the second
    expect({0.5, 0.5, 0}, 0.5 * na + 0.5 * nc);
    // A fan of three: what lies in the middle triangle must not be taken for the first.
    const Polygon<double> five({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 2, 0}, {0, 2, 0}}, {na, nb, nc, nd, na});
    EXPECT_NEAR(length(five.shading_normal({1, 1, 0}) - (na / 3.0 + nc / 3.0 + nd / 3.0)), 0, 1e-15);
}

TEST(OpenTube, keeps_the_crossings_of_the_wall_alone) {
    const OpenCylinder<double> cylinder;
    const auto ts = [](const Intervals<double>& list) {
        std::vector<double> result;
        for (const auto& span : list) {
            EXPECT_EQ(span.enter, span.exit);
            EXPECT_EQ(span.enter_face, 0);
            result.push_back(span.enter);
        }
        return result;
    };
    using List = std::vector<double>;
    EXPECT_EQ(ts(cylinder.intervals({{-3, 0, 0}, {1, 0, 0}})), (List{2, 4}));
    EXPECT_EQ(ts(cylinder.intervals({{0, 0, -3}, {0, 0, 1}})), List{}); // through the open ends
    EXPECT_EQ(ts(cylinder.intervals({{0, 0, 3}, {0.5, 0, -1.25}})),
              (List{2}));                                                    // in by the end, out by the wall
    EXPECT_EQ(ts(cylinder.intervals({{0, -3, 0}, {0, 1, 0.3}})), (List{2})); // in by the wall, out by the end
    EXPECT_EQ(ts(cylinder.intervals({{-3, 0, 2}, {1, 0, 0}})), List{});
    EXPECT_EQ(ts(cylinder.intervals({{1, 0, 0}, {-1, 0, 0}}, 0)),
              (List{0, 2})); // leaving: t = 0, and the far wall
    const OpenCone<double> cone{0.5};
    EXPECT_EQ(ts(cone.intervals({{-3, 0, 0}, {1, 0, 0}})), (List{2.25, 3.75}));
    EXPECT_EQ(ts(cone.intervals({{0, 0, -3}, {0, 0, 1}})), List{});
    EXPECT_EQ(ts(cone.intervals({{0.625, 0, 3}, {0, 0, -1}})), (List{2.5}));
    EXPECT_EQ(ts(cone.intervals({{-3, 0, 1.5}, {1, 0, 0}})), List{});
    EXPECT_EQ(ts(cone.intervals({{0.75, 0, 0}, {-1, 0, 0}}, 0)), (List{0, 1.5}));
    EXPECT_EQ(OpenCone<double>{}.intervals({{-3, 0, 0}, {1, 0, 0}}).count, 2);
}

} // namespace
} // namespace rayscope::test
