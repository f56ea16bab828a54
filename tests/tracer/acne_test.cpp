// Secondary rays start on surfaces: outward they meet nothing of a convex solid again, inward they find its far side.

#include "core/extents/scan.hpp"
#include "core/tracer/interaction.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

struct Place {
    const char* name;
    Mat4d matrix;
};

std::vector<Place> places() {
    const Mat4d turn = rotation(normalized(Vec3d{1, 2, 3}), 77);
    return {{"at home", Mat4d{1}},
            {"turned and distorted", translation({1, 2, 3}) * turn * shearing(0.5) * scaling(2, -1, 0.5)},
            {"tiny", turn * scaling(1e-6)},
            {"huge", translation({1e5, 0, 0}) * turn * scaling(1e6)},
            {"far away", translation({1e6, -1e6, 1e6}) * turn}};
}

// As seen at a hit of a ray from outside or inside; directions down to a graze of 10⁻⁶.
void expect_clean(const Generic<double>& shape, const Place& place, int count) {
    SceneBuilder b;
    b.generic(shape, place.matrix, b.clear(0.5, 0.5, 1.5));
    const Workbench bench = b.open();
    const Scan<double> stage(bench.world);
    Work<double> work;
    NullRecorder recorder;
    const bool convex = !std::holds_alternative<Torus<double>>(shape);
    const bool bounded = !std::holds_alternative<Plane<double>>(shape);
    int hits = 0;
    for (std::uint64_t seed = 1; hits < count && seed < 40 * std::uint64_t(count); ++seed) {
        Random random(seed);
        const Ray<double> object_ray = random.towards_unit_cube(random.coin() ? 4 : 0.5);
        const Ray<double> ray{transformed_point(place.matrix, object_ray.origin),
                              normalized(transformed_vector(place.matrix, object_ray.direction))};
        const Leaving<double> nothing;
        const auto hit = stage.closest(ray, Range<double>{}, nothing, work, recorder);
        if (!hit) continue;
        ++hits;
        const auto at = interact(bench.world, ray, hit, nothing, none, work);
        Vec3d d = random.direction();
        if (random.coin()) d = normalized(d - (1 - random.decade(-6, 0)) * dot(d, at.normal) * at.normal);
        const double slope = dot(d, at.normal);
        // The torus has no product of roots: a start that rounding puts beside it can miss a chord as thin as that.
        const Box<double>& box = bench.world.objects[0].bounds;
        const double beside = epsilon<double> * length(at.point) / length(box.high - box.low);
        if (std::abs(slope) < (convex ? 1e-6 : std::max(1e-6, 32 * std::sqrt(beside)))) continue;
        const bool outward = slope > 0;
        const bool stays = outward == (dot(at.facing, at.normal) > 0);
        const Ray<double> next{at.point, d};
        const auto again = stage.closest(next, Range<double>{}, stays ? at.back : at.through, work, recorder);
        const std::string what = std::string(generic_name(shape)) + ' ' + place.name + " seed " +
                                 std::to_string(seed) + (outward ? " outward " : " inward ") + hex(ray) +
                                 hex(d);
        if (outward && convex) {
            ASSERT_FALSE(bool(again)) << "t " << hex((*again).t) << ' ' << what;
        }
        if (outward && !convex && again) {
            ASSERT_TRUE((*again).entering) << what;
        }
        if (!outward && bounded) {
            ASSERT_TRUE(bool(again)) << what;
            ASSERT_FALSE((*again).entering) << what;
            ASSERT_GT((*again).t, 0) << what;
        }
    }
    EXPECT_EQ(hits, count) << generic_name(shape) << place.name;
}

TEST(Acne, no_solid_meets_itself_where_a_ray_leaves_it) {
    for (const Generic<double>& shape : solid_generics())
        for (const Place& place : places()) {
            expect_clean(shape, place, samples(2000));
            if (testing::Test::HasFatalFailure()) return;
        }
}

TEST(AcneFull, no_solid_meets_itself_where_a_ray_leaves_it) {
    for (const Generic<double>& shape : solid_generics())
        for (const Place& place : places()) {
            expect_clean(shape, place, samples(100000));
            if (testing::Test::HasFatalFailure()) return;
        }
}

// A lit convex solid is bright wherever the light is above its horizon.
TEST(Acne, a_lit_convex_solid_casts_no_shadow_on_itself) {
    for (const Generic<double>& shape : solid_generics()) {
        if (std::holds_alternative<Torus<double>>(shape)) continue;
        for (const Place& place : places()) {
            SceneBuilder b;
            SceneMaterial white = SceneBuilder::dark();
            white.diffuse = Colour{1};
            b.generic(shape, place.matrix, b.material(white));
            b.sun({1, 2, 3});
            const Workbench bench = b.open();
            for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(200)); ++seed) {
                Random random(seed);
                const Ray<double> object_ray = random.towards_unit_cube(4);
                const Ray<double> ray{transformed_point(place.matrix, object_ray.origin),
                                      transformed_vector(place.matrix, object_ray.direction)};
                const Trace trace = trace_ray(bench, {ray.origin, normalized(ray.direction)});
                const auto* hit = trace.rays[0].find<BoundaryChosen>();
                if (hit == nullptr || !hit->entering) continue;
                const double cosine = dot(hit->facing, normalized(Vec3d{1, 2, 3}));
                if (cosine < 1e-6) continue;
                ASSERT_NEAR(trace.colour.x, cosine, 1e-12)
                    << generic_name(shape) << place.name << hex(ray) << seed;
            }
        }
    }
}

} // namespace
} // namespace rayscope::test
