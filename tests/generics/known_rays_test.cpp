// Rays whose crossings one can see at a glance.

#include "tests/support/hex.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

constexpr double inf = infinity<double>;
constexpr int any = -1; // an end where two faces meet may name either

struct Expected {
    double enter, exit;
    int enter_face = 0, exit_face = 0;
};

void expect_spans(const Generic<double>& shape, const Ray<double>& ray, const std::vector<Expected>& expected,
                  int leaving = no_face) {
    SCOPED_TRACE(std::string(generic_name(shape)) + ' ' + hex(ray));
    const Intervals<double> found = intervals(shape, ray, leaving);
    ASSERT_EQ(found.count, int(expected.size()));
    for (std::size_t i = 0; i < expected.size(); ++i) {
        const Interval<double>& span = found.items[i];
        EXPECT_DOUBLE_EQ(span.enter, expected[i].enter);
        EXPECT_DOUBLE_EQ(span.exit, expected[i].exit);
        if (std::isfinite(span.enter) && expected[i].enter_face != any) {
            EXPECT_EQ(span.enter_face, expected[i].enter_face);
        }
        if (std::isfinite(span.exit) && expected[i].exit_face != any) {
            EXPECT_EQ(span.exit_face, expected[i].exit_face);
        }
    }
}

TEST(KnownRays, sphere) {
    const Sphere<double> sphere;
    expect_spans(sphere, {{0, 0, 5}, {0, 0, -1}}, {{4, 6}});
    expect_spans(sphere, {{0, 0, 5}, {0, 0, -2}}, {{2, 3}});    // t counts in lengths of the direction
    expect_spans(sphere, {{0, 0, -5}, {0, 0, -1}}, {{-6, -4}}); // behind
    expect_spans(sphere, {{0, 0, 0}, {0, 1, 0}}, {{-1, 1}});
    expect_spans(sphere, {{0, 0, 0.5}, {0, 0, 1}}, {{-1.5, 0.5}});
    expect_spans(sphere, {{0.6, 0, 5}, {0, -0.0, -1}}, {{4.2, 5.8}});
    expect_spans(sphere, {{1.001, 0, 5}, {0, 0, -1}}, {});
    expect_spans(sphere, {{1, 0, 5}, {0, 0, -1}}, {}); // touches
    expect_spans(Sphere<double>{2}, {{0, 0, 5}, {0, 0, -1}}, {{3, 7}});
    expect_spans(Sphere<double>{2}, {{1.2, 0, 5}, {0, 0, -1}}, {{3.4, 6.6}});
}

TEST(KnownRays, plane) {
    const Plane<double> plane;
    expect_spans(plane, {{1, 2, 3}, {0, 0, -1}}, {{3, inf}});
    expect_spans(plane, {{1, 2, 3}, {0, 0, 2}}, {{-inf, -1.5}});
    expect_spans(plane, {{1, 2, -3}, {1, 0, 1}}, {{-inf, 3}});
    expect_spans(plane, {{1, 2, -3}, {1, 0, 0}}, {{-inf, inf}});
    expect_spans(plane, {{1, 2, 3}, {1, 0, 0}}, {});
    expect_spans(plane, {{1, 2, -3}, {1, 0, -0.0}}, {{-inf, inf}});
    expect_spans(plane, {{1, 2, 3}, {1, 0, -0.0}}, {});
    expect_spans(plane, {{1, 2, 0}, {1, 0, 0}}, {{-inf, inf}}); // in the boundary, which belongs to it
}

TEST(KnownRays, cylinder) {
    const Cylinder<double> cylinder;
    constexpr int wall = 0, bottom = 1, top = 2;
    expect_spans(cylinder, {{5, 0, 0}, {-1, 0, 0}}, {{4, 6, wall, wall}});
    expect_spans(cylinder, {{0.3, 0.2, 5}, {0, 0, -1}}, {{4, 6, top, bottom}});
    expect_spans(cylinder, {{0.3, 0.2, -5}, {0, 0, 1}}, {{4, 6, bottom, top}});
    expect_spans(cylinder, {{0, 0, 3}, {0.3, 0, -1}}, {{2, 10.0 / 3, top, wall}});
    expect_spans(cylinder, {{0, -3, 0}, {0, 1, 0.3}}, {{2, 10.0 / 3, wall, top}});
    expect_spans(cylinder, {{0, 0, 0}, {0, 1, 0}}, {{-1, 1, wall, wall}});
    expect_spans(cylinder, {{5, 0, 0}, {1, 0, 0}}, {{-6, -4, wall, wall}});
    expect_spans(cylinder, {{0.5, 0, 0}, {-0.0, 0.0, 1}}, {{-1, 1, bottom, top}});
    expect_spans(cylinder, {{5, 0, 1}, {-1, 0, 0}}, {}); // in the plane of a cap
    expect_spans(cylinder, {{5, 0, 1}, {-1, 0, -0.0}}, {});
    expect_spans(cylinder, {{5, 0, 1.5}, {-1, 0, 0}}, {}); // above
    expect_spans(cylinder, {{5, 1, 0}, {-1, 0, 0}}, {});   // touches the wall
    expect_spans(cylinder, {{2, 0, 5}, {0, 0, -1}}, {});   // beside the axis
    expect_spans(cylinder, {{5, 5, 0}, {-1, 1, 0}}, {});
    expect_spans(cylinder, {{1, 0, 5}, {0, 0, -1}},
                 {{4, 6, top, bottom}});                 // in the wall, which belongs to it
    expect_spans(cylinder, {{0, 0, 2}, {1, 0, -1}}, {}); // touches the rim from outside
    expect_spans(cylinder, {{2, 0, 0}, {-1, 0, 1}}, {});
}

TEST(KnownRays, cylinder_through_both_rims) {
    const Intervals<double> found = intervals(Cylinder<double>{}, {{-2, 0, -2}, {1, 0, 1}});
    ASSERT_EQ(found.count, 1); // cap and wall at once: still one way in and one way out
    EXPECT_EQ(found.items[0].enter, 1);
    EXPECT_EQ(found.items[0].exit, 3);
}

TEST(KnownRays, cone) {
    const Cone<double> cone;
    constexpr int wall = 0, base = 1;
    expect_spans(cone, {{5, 0, 0}, {-1, 0, 0}}, {{4.5, 5.5, wall, wall}});
    expect_spans(cone, {{0, 0, 5}, {0, 0, -1}}, {{4, 6, any, base}}); // down the axis, through the apex
    expect_spans(cone, {{0, 0, -5}, {0, 0, 1}}, {{4, 6, base, any}});
    expect_spans(cone, {{0.5, 0, 5}, {0, 0, -1}}, {{5, 6, wall, base}});
    expect_spans(cone, {{0.5, 0, -5}, {0, 0, 1}}, {{4, 5, base, wall}});
    expect_spans(cone, {{0, 0, 0}, {0, 0, 1}}, {{-1, 1, base, any}});
    expect_spans(cone, {{0, 0.5, -0.5}, {0, 0, 1}}, {{-0.5, 0.5, base, wall}});
    expect_spans(cone, {{5, 0, 1}, {-1, 0, 0}}, {});     // through the apex alone
    expect_spans(cone, {{5, 0, 1.5}, {-1, 0, 0}}, {});   // through the other nappe
    expect_spans(cone, {{0.25, 0, 5}, {0, 0.5, 0}}, {}); // above it, inside the other nappe
    expect_spans(cone, {{5, 0, -1}, {-1, 0, 0}}, {});    // in the plane of the base
    expect_spans(cone, {{5, 2, 0}, {-1, 0, 0}}, {});
    expect_spans(cone, {{-2, 0, 0}, {1, 0, 0}}, {{1.5, 2.5, wall, wall}});
    expect_spans(cone, {{1, 0, -2}, {-1, 0, 1}}, {{1, 5.0 / 3, base, wall}});
    expect_spans(cone, {{-3, 0, 2.5}, {1, 0, -1}}, {{2.5, 3.5, wall, base}});
}

TEST(KnownRays, cone_parallel_to_a_generator) {
    const Cone<double> cone;
    constexpr int wall = 0, base = 1;
    // A generator falls 2 while it runs 1. What is parallel to it has one crossing with the wall.
    expect_spans(cone, {{0.3, 0, -3}, {-0.5, 0, 1}}, {{2, 2.3, base, wall}});
    expect_spans(cone, {{-1.2, 0, 0}, {0.5, 0, -1}}, {{0.7, 1, wall, base}});
    expect_spans(cone, {{0, -1.2, 0}, {0, 0.5, -1}}, {{0.7, 1, wall, base}});
    expect_spans(cone, {{0.3, 0.2, -3}, {-0.5, 0, 1}}, {{2, 3.87 / 1.7, base, wall}});
    expect_spans(cone, {{1, 0, 0}, {-0.5, 0, 1}}, {});
    expect_spans(cone, {{0.5, 0.3, 0}, {-0.5, 0, 1}},
                 {});                       // in the plane that touches the cone along a generator
    for (const double side : {-1.0, 1.0}) { // the generator itself: in or out, never a half
        const Intervals<double> found = intervals(cone, {{0.5, 0, 0}, {-0.5 * side, 0, side}});
        for (const Interval<double>& span : found) EXPECT_FALSE(span.empty());
    }
}

TEST(KnownRays, truncated_cone) {
    const Cone<double> cone{0.5};
    constexpr int wall = 0, base = 1, lid = 2;
    expect_spans(cone, {{5, 0, 0}, {-1, 0, 0}}, {{4.25, 5.75, wall, wall}});
    expect_spans(cone, {{0, 5, 0.5}, {0, -1, 0}}, {{4.375, 5.625, wall, wall}});
    expect_spans(cone, {{0, 0, 5}, {0, 0, -1}}, {{4, 6, lid, base}});
    expect_spans(cone, {{0.4, 0, -5}, {0, 0, 1}}, {{4, 6, base, lid}});
    expect_spans(cone, {{0.6, 0, 5}, {0, 0, -1}}, {{4.4, 6, wall, base}});
    expect_spans(cone, {{0.6, 0, -5}, {0, 0, 1}}, {{4, 5.6, base, wall}});
    expect_spans(cone, {{5, 0, 1}, {-1, 0, 0}}, {}); // in the plane of the lid
}

TEST(KnownRays, cube) {
    const Cube<double> cube;
    for (int axis = 0; axis < 3; ++axis)
        for (const double zero : {0.0, -0.0}) {
            Ray<double> ray{Vec3d{0.25}, Vec3d{zero}};
            ray.origin[axis] = 5;
            ray.direction[axis] = -1;
            expect_spans(cube, ray, {{4, 6, 2 * axis + 1, 2 * axis}});
            ray.direction[axis] = 1;
            expect_spans(cube, ray, {{-6, -4, 2 * axis, 2 * axis + 1}});
            for (const double beside : {1.0, -1.0, 1.5, -1.5}) { // in a face's plane, and outside it
                Ray<double> off = ray;
                off.origin[(axis + 1) % 3] = beside;
                expect_spans(cube, off, {});
                off.origin[(axis + 1) % 3] = 0.25;
                off.origin[(axis + 2) % 3] = beside;
                expect_spans(cube, off, {});
            }
        }
    expect_spans(cube, {{0, 0, 0}, {1, 0.5, 0.25}}, {{-1, 1, 0, 1}});
    expect_spans(cube, {{-3, -2.5, 0}, {1, 1, 0}}, {{2, 3.5, 0, 3}});
    expect_spans(cube, {{-3, 0, -2.5}, {1, 0, 1}}, {{2, 3.5, 0, 5}});
    expect_spans(cube, {{-2, 0, 0}, {1, 1, 0}}, {}); // along an edge's corner
}

TEST(KnownRays, torus) {
    const Torus<double> torus{0.25};
    expect_spans(torus, {{5, 0, 0}, {-1, 0, 0}}, {{3.75, 4.25}, {5.75, 6.25}});
    expect_spans(torus, {{5, 0, 0}, {1, 0, 0}}, {{-6.25, -5.75}, {-4.25, -3.75}});
    expect_spans(torus, {{5, 0, 0.2}, {-1, 0, 0}}, {{3.85, 4.15}, {5.85, 6.15}});
    expect_spans(torus, {{0, -1, 5}, {0, 0, -1}}, {{4.75, 5.25}});
    expect_spans(torus, {{5, 1, 0}, {-1, 0, 0}}, {{4.25, 5.75}}); // along the ring
    expect_spans(torus, {{1, 0, 0}, {0, 0, 1}}, {{-0.25, 0.25}});
    expect_spans(torus, {{0, 0, 0}, {1, 0, 0}}, {{-1.25, -0.75}, {0.75, 1.25}});
    expect_spans(torus, {{0, 0, 5}, {0, 0, -1}}, {}); // through the hole
    expect_spans(torus, {{0.7, 0, 5}, {0, 0, -1}}, {});
    expect_spans(torus, {{5, 0, 0.3}, {-1, 0, 0}}, {});
    expect_spans(torus, {{5, 1.3, 0}, {-1, 0, 0}}, {});
    const double inner = std::sqrt(0.3125), outer = std::sqrt(1.3125); // y = ½ across both circles
    expect_spans(torus, {{0, 0.5, 0}, {2, 0, 0}}, {{-outer / 2, -inner / 2}, {inner / 2, outer / 2}});
}

TEST(KnownRays, leaving_a_face_begins_at_zero_exactly) {
    expect_spans(Sphere<double>{}, {{0, 0.6, 0.8}, {0, 0, 1}}, {{-1.6, 0}}, 0);
    expect_spans(Sphere<double>{}, {{0, 0.6, 0.8}, {0, 0, -2}}, {{0, 0.8}}, 0);
    expect_spans(Sphere<double>{}, {{0, 0, 1}, {1, 0, 0}}, {}, 0);
    expect_spans(Plane<double>{}, {{3, 2, 1e-9}, {0, 0, 1}}, {{-inf, 0}}, 0);
    expect_spans(Plane<double>{}, {{3, 2, 1e-9}, {0, 0, -1}}, {{0, inf}}, 0);
    expect_spans(Plane<double>{}, {{3, 2, -1e-9}, {1, 0, 0}}, {}, 0);
    expect_spans(Cylinder<double>{}, {{1, 0, 0}, {1, 0, 0}}, {{-2, 0, 0, 0}}, 0);
    expect_spans(Cylinder<double>{}, {{1, 0, 0}, {-1, 0, 0}}, {{0, 2, 0, 0}}, 0);
    expect_spans(Cylinder<double>{}, {{1, 0, 0}, {-1, 0, 1}}, {{0, 1, 0, 2}}, 0);
    expect_spans(Cylinder<double>{}, {{1, 0, 0}, {0, 0, 1}}, {}, 0); // along the wall: outside
    expect_spans(Cylinder<double>{}, {{1, 0, 0}, {0, 1, 0}}, {}, 0);
    expect_spans(Cylinder<double>{}, {{0.5, 0, 1 + 1e-9}, {0, 0, -1}}, {{0, 2 + 1e-9, 2, 1}}, 2);
    expect_spans(Cylinder<double>{}, {{0.5, 0, -1 - 1e-9}, {0, 0, -1}}, {{-2 - 1e-9, 0, 2, 1}}, 1);
    expect_spans(Cylinder<double>{}, {{0.5, 0, 1 - 1e-9}, {1, 0, 0}}, {}, 2);
    expect_spans(Cylinder<double>{}, {{0.5, 0, -1 + 1e-9}, {1, 0, 0}}, {}, 1);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {1, 0, 0}}, {{-1, 0, 0, 0}}, 0);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {-1, 0, 0}}, {{0, 1, 0, 0}}, 0);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {0, 0, 1}}, {{-1, 0, 1, 0}}, 0);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {0, 0, -1}}, {{0, 1, 0, 1}}, 0);
    // Parallel to the opposite generator: the leaving root is the only one.
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {-0.5, 0, -1}}, {{0, 1, 0, 1}}, 0);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {0.5, 0, 1}}, {{-1, 0, 1, 0}}, 0);
    expect_spans(Cone<double>{}, {{0.5, 0, 0}, {-0.5, 0, 1}}, {}, 0); // along its own generator
    expect_spans(Cube<double>{}, {{1, 0, 0}, {1, 0, 0}}, {{-2, 0, 0, 1}}, 1);
    expect_spans(Cube<double>{}, {{1, 0, 0}, {0, 1, 0}}, {}, 1);
    expect_spans(Cube<double>{}, {{1 - 1e-9, 0, 0}, {0, 1, 0}}, {}, 1);
    expect_spans(Torus<double>{}, {{1.25, 0, 0}, {-1, 0, 0}}, {{0, 0.5}, {2, 2.5}}, 0);
    expect_spans(Torus<double>{}, {{1.25, 0, 0}, {1, 0, 0}}, {{-2.5, -2}, {-0.5, 0}}, 0);
    expect_spans(Torus<double>{}, {{0.75, 0, 0}, {-1, 0, 0}}, {{-0.5, 0}, {1.5, 2}}, 0);
    expect_spans(Torus<double>{}, {{0.75, 0, 0}, {2, 0, 0}}, {{-1, -0.75}, {0, 0.25}}, 0);
    // A start that is beside the torus by more than the graze is deep has no crossing of its own: the far side stays.
    const Intervals<double> far = intervals(Torus<double>{}, {{1, 0, 0.25 + 0x1p-20}, {-1, 0, -0x1p-13}}, 0);
    ASSERT_EQ(far.count, 1);
    EXPECT_GT(far.items[0].enter, 1.9);
    EXPECT_EQ(intervals(triangle(), {{0, 0, 1e-9}, {0, 0, -1}}, 0).count, 0);
}

} // namespace
} // namespace rayscope::test
