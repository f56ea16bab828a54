// What a heat map shows of a pixel is what its traces did.

#include "core/rayscope.hpp"
#include "tests/tracer/crowd.hpp"

#include <gtest/gtest.h>

#include <map>

namespace rayscope::test {
namespace {

TEST(Heat, is_what_the_counters_say) {
    const Workbench bench = make_workbench(crowd());
    RenderOptions options;
    options.stage = stage_choice("octree");
    for (const Heat heat : {Heat::rays, Heat::tests, Heat::cells}) {
        options.heat = heat;
        const RenderResult result = render(bench, options);
        double sum = 0;
        for (const float value : result.heat.values) sum += double(value);
        const Counters& c = result.statistics.counters;
        std::uint64_t expected = 0;
        if (heat == Heat::rays)
            for (const auto count : c.rays) expected += count;
        if (heat == Heat::tests)
            for (const auto count : c.tests) expected += count;
        if (heat == Heat::cells) expected = c.nodes + c.cells + c.boxes;
        EXPECT_EQ(sum, double(expected)) << heat_names[std::size_t(heat)].name;
    }
}

TEST(Extents, of_what_has_no_end_are_not_counted) {
    SceneBuilder b;
    b.generic(Sphere<double>{}, Mat4d{1}, b.clear(0, 0, 1), "ball");
    b.generic(Plane<double>{}, translation({0, 0, -3}), b.clear(0, 0, 1), "floor");
    RenderOptions options;
    options.width = options.height = 16;
    options.stage = stage_choice("extents");
    EXPECT_EQ(render(b.open(), options).statistics.counters.boxes, 256U);
}

// Who holds the eye is looked up before any stage was asked.
TEST(Counters, do_not_depend_on_the_number_of_threads) {
    SceneBuilder b;
    SceneMaterial glass;
    glass.transmission = Colour{0.7};
    glass.speed = 1 / 1.3;
    glass.absorption = Colour{0.1};
    const std::size_t material = b.material(glass);
    std::string inside;
    for (int i = 0; i < 12; ++i) {
        const std::string name = "ring" + std::to_string(i);
        b.operand(name, Torus<double>{}, translation(Vec3d{4.0 * (i - 6), 0, 0}));
        inside += (i > 0 ? "|" : "") + name;
    }
    b.compound("water", "!(" + inside + ")", material);
    b.generic(Sphere<double>{}, scaling(0.1), material, "ball");
    b.scene().camera.width = b.scene().camera.height = 48;
    const Workbench bench = b.open();
    RenderOptions options;
    options.stage = stage_choice("octree");
    options.heat = Heat::tests;
    options.threads = 1;
    const RenderResult one = render(bench, options);
    EXPECT_EQ(one.heat.values[0], one.heat.values[1]);
    options.threads = 4;
    const RenderResult four = render(bench, options);
    EXPECT_EQ(four.heat.values, one.heat.values);
    EXPECT_EQ(four.statistics.counters.boxes, one.statistics.counters.boxes);
}

TEST(Heat, depth_is_that_of_the_deepest_ray_in_the_trace) {
    const Workbench bench = make_workbench(crowd());
    RenderOptions options;
    options.heat = Heat::depth;
    const RenderResult result = render(bench, options);
    float deepest = 0;
    for (int x = 1; x < 64; x += 7)
        for (int y = 1; y < 48; y += 7) {
            int depth = 0;
            for (const TracedRay& ray : trace_pixel(bench, x, y).rays)
                depth = std::max(depth, ray.start().depth);
            EXPECT_EQ(result.heat.at(x, y), float(depth));
            deepest = std::max(deepest, result.heat.at(x, y));
        }
    EXPECT_GT(deepest, 0);
}

// What the ledger of the recorded trace says of single pixels; of each pixel they are the whole.
TEST(Heat, light_is_that_of_the_ledger_and_adds_up_to_the_image) {
    Scene glass = crowd();
    glass.materials[1].transmission = Colour{0.5, 0.6, 0.7};
    glass.materials[1].absorption = Colour{0.4, 0.2, 0.1};
    glass.background = Colour{0.1, 0.2, 0.3};
    for (const Scene& scene : {crowd(), glass}) {
        const Workbench bench = make_workbench(scene);
        for (const int samples : {1, 5}) {
            RenderOptions options;
            options.samples = samples;
            std::map<Heat, RenderResult> maps;
            for (const Heat heat : {Heat::direct, Heat::reflected, Heat::refracted}) {
                options.heat = heat;
                maps[heat] = render(bench, options);
            }
            const Image& image = maps[Heat::direct].image;
            for (int x = 0; x < image.width; ++x)
                for (int y = 0; y < image.height; ++y) {
                    const Colour& c = image.at(x, y);
                    double sum = 0;
                    for (const auto& [heat, result] : maps) sum += double(result.heat.at(x, y));
                    ASSERT_NEAR(sum, (c.x + c.y + c.z) / 3, 1e-6) << x << ' ' << y;
                    if (samples > 1 || (x + y) % 17 != 0) continue;
                    std::map<RayKind, double> brought;
                    for (const auto& [source, light] : ledger_of(trace_pixel(bench, x, y).rays).sources)
                        brought[source.brought_by] += (light.x + light.y + light.z) / 3;
                    for (const auto& [heat, result] : maps)
                        ASSERT_NEAR(double(result.heat.at(x, y)),
                                    brought[RayKind(int(heat) - int(Heat::direct))], 1e-6);
                }
        }
    }
}

} // namespace
} // namespace rayscope::test
