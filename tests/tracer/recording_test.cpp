// The record is of the same light as the image, and complete.

#include "core/scene/read_toml.hpp"
#include "core/trace/check_trace.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace rayscope::test {
namespace {

std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYSCOPE_SOURCE_DIR "/chapters"))
        if (entry.path().extension() == ".toml") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

// Where each wavelength has a ray of its own, its boundary tells of as many.
Colour coefficient_of(const TracedRay& parent, const RaySpawned& child) {
    if (child.kind == RayKind::reflected) return parent.find<Reflected>()->coefficient;
    for (const Event& event : parent.events)
        if (const auto* bent = std::get_if<Refracted>(&event))
            if (bent->wavelength == child.wavelength) return bent->coefficient;
    return Colour{0};
}

// Colour = what absorption leaves of local light + Σ coefficient · the child's colour, in the order of the children; bit
// for bit.
void expect_sums(const Trace& trace) {
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        ASSERT_FALSE(ray.events.empty());
        ASSERT_TRUE(std::holds_alternative<RaySpawned>(ray.events.front())) << "ray " << i;
        ASSERT_TRUE(std::holds_alternative<RayFinished>(ray.events.back())) << "ray " << i;
        for (std::size_t k = 1; k + 1 < ray.events.size(); ++k) {
            ASSERT_FALSE(std::holds_alternative<RaySpawned>(ray.events[k])) << "ray " << i;
            ASSERT_FALSE(std::holds_alternative<RayFinished>(ray.events[k])) << "ray " << i;
        }
        const auto& end = std::get<RayFinished>(ray.events.back());
        ASSERT_GE(end.rejected, 0);
        Colour local{0}, passed{1};
        if (const auto* absorbed = ray.find<Absorbed>()) passed = absorbed->passed;
        if (const auto* ambient = ray.find<AmbientLit>()) local = ambient->scene * ambient->material;
        for (const Event& event : ray.events)
            if (const auto* lit = std::get_if<LightLit>(&event)) local += lit->diffuse + lit->specular;
        if (const auto* missed = ray.find<Missed>()) local = missed->background;
        if (ray.start().kind == RayKind::shadow) continue;
        ASSERT_EQ(end.local, local * passed) << "ray " << i;
        Colour sum = local;
        for (const int child : ray.children) {
            const TracedRay& next = trace.rays[std::size_t(child)];
            const RaySpawned& start = next.start();
            if (start.kind == RayKind::shadow) continue;
            const Colour coefficient = coefficient_of(ray, start);
            sum += coefficient * std::get<RayFinished>(next.events.back()).colour;
            ASSERT_EQ(start.depth, ray.start().depth + 1);
            ASSERT_EQ(start.weight, ray.start().weight * passed * coefficient);
            ASSERT_EQ(start.origin, ray.find<BoundaryChosen>()->point);
        }
        ASSERT_EQ(end.colour, sum * passed) << "ray " << i;
    }
    ASSERT_EQ(std::get<RayFinished>(trace.rays[0].events.back()).colour, trace.colour);
    ASSERT_EQ(trace.events_dropped, 0U);
    ASSERT_NO_THROW(check_trace(trace));
}

// The inside lists in the eye ray's record, of the author's trees, are those of the public face.
void expect_spans(const Trace& trace, const Workbench& bench) {
    const TracedRay& eye = trace.rays[0];
    const auto lists = spans(bench, {eye.start().origin, eye.start().direction});
    for (std::size_t e = 0; e < eye.events.size(); ++e) {
        const auto* node = std::get_if<NodeEvaluated>(&eye.events[e]);
        if (node == nullptr) continue;
        const TraceObject& object = trace.objects[std::size_t(node->object)];
        if (std::size_t(node->node) + 1 != object.nodes.size()) continue;
        const auto drawn =
            std::find_if(bench.scene.drawn.begin(), bench.scene.drawn.end(), [&](const SceneObject& o) {
                return object.name == (o.is_compound ? bench.scene.compounds[o.index].name
                                                     : bench.scene.generics[o.index].name);
            });
        ASSERT_NE(drawn, bench.scene.drawn.end());
        const Spans<double>& list = lists[std::size_t(drawn - bench.scene.drawn.begin())];
        const auto recorded = spans_after(eye, e);
        ASSERT_EQ(recorded.size(), list.size()) << object.name;
        for (std::size_t i = 0; i < list.size(); ++i) {
            ASSERT_EQ(recorded[i].enter.t, list[i].enter.t);
            ASSERT_EQ(recorded[i].exit.t, list[i].exit.t);
            ASSERT_EQ(recorded[i].enter.flipped, list[i].enter.surface.flipped);
            if (std::isfinite(list[i].exit.t)) {
                ASSERT_EQ(recorded[i].exit.face, int(list[i].exit.surface.face));
            }
        }
    }
}

void expect_the_image(const std::filesystem::path& path, int width, int height) {
    SCOPED_TRACE(path.filename().string());
    const Workbench bench = open(path);
    RenderOptions options;
    options.width = width;
    options.height = height;
    options.samples = 1;
    const RenderResult result = render(bench, options);
    ASSERT_TRUE(result.complete);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Trace trace = trace_pixel(bench, x, y, width, height);
            for (int i = 0; i < 3; ++i) {
                ASSERT_EQ(result.image.rgb[std::size_t(3 * (y * width + x) + i)], float(trace.colour[i]))
                    << x << ',' << y;
            }
            expect_sums(trace);
            expect_spans(trace, bench);
            if (testing::Test::HasFatalFailure()) {
                ADD_FAILURE() << "at pixel " << x << ',' << y;
                return;
            }
        }
}

TEST(Recording, is_of_the_same_light_as_the_image) {
    ASSERT_GE(shipped_scenes().size(), 8U);
    for (const auto& path : shipped_scenes()) expect_the_image(path, 16, 12);
}

TEST(RecordingFull, is_of_the_same_light_as_the_image) {
    for (const auto& path : shipped_scenes()) expect_the_image(path, 96, 72);
}

TEST(Recording, the_counts_of_tests_match_what_was_accepted) {
    SceneBuilder b;
    const auto m = b.glowing({1, 1, 1});
    for (int i = 0; i < 5; ++i) b.generic(Sphere<double>{}, translation({3.0 * i, 0, 0}), m);
    b.generic(Cube<double>{}, translation({0, 0, -5}), m);
    const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}});
    const auto& end = std::get<RayFinished>(trace.rays[0].events.back());
    EXPECT_EQ(end.tested, 6);
    EXPECT_EQ(end.rejected, 4);
}

TEST(Recording, a_ray_by_hand_keeps_its_length_for_t) {
    SceneBuilder b;
    SceneMaterial white = SceneBuilder::dark();
    white.diffuse = Colour{1};
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(white));
    b.light({0, 0, 9});
    for (const double size : {1.0, 4.0, 0.25, 1e-100, 1e100}) {
        const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -size}});
        EXPECT_TRUE(trace.source.by_hand);
        EXPECT_DOUBLE_EQ(trace.source.given_length, size);
        const auto* hit = trace.rays[0].find<BoundaryChosen>();
        ASSERT_NE(hit, nullptr) << size;
        EXPECT_DOUBLE_EQ(hit->boundary.t, 4 / size);
        EXPECT_LE(length(trace.colour - Colour{1}), 4 * epsilon<double>) << size;
    }
}

TEST(Render, is_the_same_for_any_number_of_threads) {
    for (const auto& path : shipped_scenes()) {
        const Workbench bench = open(path);
        std::vector<std::uint64_t> hashes;
        std::vector<Counters> counters;
        for (const int threads : {1, 2, 3, 7}) {
            RenderOptions options;
            options.width = 70;
            options.height = 50;
            options.threads = threads;
            const RenderResult result = render(bench, options);
            hashes.push_back(hash(result.image));
            counters.push_back(result.statistics.counters);
        }
        for (std::size_t i = 1; i < hashes.size(); ++i) {
            EXPECT_EQ(hashes[i], hashes[0]) << path;
            EXPECT_EQ(counters[i].rays, counters[0].rays) << path;
            EXPECT_EQ(counters[i].tests, counters[0].tests) << path;
        }
        if (bench.scene.camera.samples == 1) {
            EXPECT_EQ(counters[0].rays[std::size_t(RayKind::eye)], 3500U);
        }
    }
}

TEST(Render, stops_early_when_asked_and_tells_how_far_it_is) {
    SceneBuilder b;
    b.generic(Sphere<double>{}, Mat4d{1}, b.glowing({1, 1, 1}));
    const Workbench bench = b.open();
    std::atomic<bool> stop = true;
    RenderOptions options;
    options.width = options.height = 64;
    options.stop = &stop;
    EXPECT_FALSE(render(bench, options).complete);
    stop = false;
    std::vector<double> told;
    options.progress = [&](double done) { told.push_back(done); };
    EXPECT_TRUE(render(bench, options).complete);
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 1);
    options.progress = [&](double) { stop = true; }; // half way
    options.threads = 1;
    const RenderResult cut = render(bench, options);
    EXPECT_FALSE(cut.complete);
    EXPECT_LT(cut.statistics.counters.rays[0], 64U * 64U);
}

} // namespace
} // namespace rayscope::test
