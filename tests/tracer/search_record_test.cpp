// A trace by the way of a stage is the same trace, and tells truly where the stage looked.

#include "core/rayscope.hpp"
#include "tests/tracer/crowd.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace rayscope::test {
namespace {

std::vector<StageChoice> choices() {
    std::vector<StageChoice> list;
    for (const Rung& rung : rungs) list.push_back(rung.choice);
    return list;
}

template <typename E> std::vector<E> all(const TracedRay& ray) {
    std::vector<E> list;
    for (const Event& event : ray.events)
        if (const auto* found = std::get_if<E>(&event)) list.push_back(*found);
    return list;
}

// Answers alone: which objects were tested besides, and in which order, is the stage's own affair.
void expect_same_answers(const Trace& a, const Trace& b) {
    ASSERT_EQ(a.rays.size(), b.rays.size());
    ASSERT_EQ(a.colour, b.colour);
    for (std::size_t i = 0; i < a.rays.size(); ++i) {
        const auto *p = a.rays[i].find<BoundaryChosen>(), *q = b.rays[i].find<BoundaryChosen>();
        ASSERT_EQ(p == nullptr, q == nullptr);
        if (p == nullptr) continue;
        ASSERT_EQ(p->boundary.t, q->boundary.t);
        ASSERT_EQ(a.objects[std::size_t(p->object)].name, b.objects[std::size_t(q->object)].name);
    }
}

TEST(SearchRecord, every_stage_traces_the_same_rays_to_the_same_hits) {
    const Workbench bench = make_workbench(crowd());
    for (const StageChoice& choice : choices()) {
        SCOPED_TRACE(described(choice));
        const auto stages = make_stages(bench, choice);
        for (int x = 3; x < 64; x += 10)
            for (int y = 3; y < 48; y += 10)
                expect_same_answers(trace_pixel(bench, x, y), trace_pixel(bench, *stages, x, y));
    }
}

// 10⁶ places are not needed to see a wrong count: what is found in the record must be what the end of it says.
TEST(SearchRecord, its_end_counts_what_it_holds) {
    const Workbench bench = make_workbench(crowd());
    for (const StageChoice& choice : choices()) {
        SCOPED_TRACE(described(choice));
        const auto stages = make_stages(bench, choice);
        const Trace trace = trace_pixel(bench, *stages, 32, 24);
        for (const TracedRay& ray : trace.rays) {
            const auto began = all<SearchBegan>(ray);
            const auto ended = all<SearchEnded>(ray);
            ASSERT_EQ(began.size(), ended.size());
            if (began.empty()) { // what the ray leaves stopped it
                ASSERT_EQ(ray.start().kind, RayKind::shadow);
                continue;
            }
            ASSERT_EQ(began.size(), 1U);
            ASSERT_EQ(began[0].objects, 61);
            int places = 0;
            for (const PlaceEntered& place : all<PlaceEntered>(ray))
                places += place.kind == PlaceKind::tile || place.kind == PlaceKind::light_cell ||
                                  place.kind == PlaceKind::cell
                              ? 1
                              : 0;
            ASSERT_EQ(places, ended[0].places);
            ASSERT_EQ(ended[0].spared, std::max(0, 61 - ended[0].tested));
            ASSERT_EQ(ray.find<RayFinished>()->tested, ended[0].tested);
            for (const PlaceLeft& left : all<PlaceLeft>(ray)) ASSERT_LE(left.tested, ended[0].tested);
        }
    }
}

TEST(SearchRecord, boxes_hold_the_ray_from_t_in_to_t_out_and_one_of_them_the_hit) {
    const Workbench bench = make_workbench(crowd());
    for (const char* name : {"octree", "bvh", "extents"}) {
        SCOPED_TRACE(name);
        const auto stages = make_stages(bench, stage_choice(name));
        int boxes = 0;
        for (int pixel = 0; pixel < 64 * 48; pixel += 29) {
            const Trace trace = trace_pixel(bench, *stages, pixel % 64, pixel / 64);
            for (const TracedRay& ray : trace.rays) {
                const RaySpawned& start = ray.start();
                const auto* hit = ray.find<BoundaryChosen>();
                bool hit_in_a_box = false, hit_is_bounded = false;
                if (hit != nullptr)
                    hit_is_bounded =
                        trace.objects[std::size_t(hit->object)].name.find("plane") == std::string::npos;
                for (const PlaceEntered& place : all<PlaceEntered>(ray)) {
                    if (place.kind == PlaceKind::node) continue; // the root is not asked before it is entered
                    ASSERT_LE(place.t_in, place.t_out);
                    ++boxes;
                    const Vec3d in = start.origin + start.direction * place.t_in;
                    for (int axis = 0; axis < 3; ++axis) {
                        ASSERT_GE(in[axis], place.low[axis] - 1e-5);
                        ASSERT_LE(in[axis], place.high[axis] + 1e-5);
                    }
                    hit_in_a_box = hit_in_a_box || (hit != nullptr && place.t_in <= hit->boundary.t + 1e-9 &&
                                                    hit->boundary.t <= place.t_out + 1e-9);
                }
                if (hit_is_bounded) {
                    ASSERT_TRUE(hit_in_a_box);
                }
            }
        }
        EXPECT_GT(boxes, 20);
    }
}

/// A row of balls along x, joined to one object.
Scene chain_of_balls(int count) {
    SceneBuilder b;
    std::string all;
    for (int i = 0; i < count; ++i) {
        const std::string name = "b" + std::to_string(i);
        b.operand(name, Sphere<double>{}, translation({3.0 * i, 0, 0}));
        all += (i == 0 ? "" : " | ") + name;
    }
    b.compound("chain", all, b.material(SceneMaterial{}));
    b.light({0, -50, 50});
    return b.scene();
}

TEST(SearchRecord, of_a_compound_holds_the_boxes_of_its_parts_that_the_ray_enters) {
    const Workbench bench = make_workbench(chain_of_balls(64));
    const Ray<double> ray{{60.2, -10, 0.3}, {0, 1, 0}}; // at the ball in 60
    for (const char* name : {"scan", "extents", "octree", "bvh"}) {
        SCOPED_TRACE(name);
        const Trace trace = trace_ray(bench, *make_stages(bench, stage_choice(name)), ray);
        const TracedRay& eye = trace.rays.front();
        std::vector<PlaceEntered> parts = all<PlaceEntered>(eye);
        std::erase_if(parts, [](const PlaceEntered& place) { return place.kind != PlaceKind::part; });
        const SearchEnded end = all<SearchEnded>(eye).at(0);
        if (std::string(name) == "scan") {
            EXPECT_TRUE(parts.empty());
            EXPECT_EQ(end.missed, 0);
            continue;
        }
        ASSERT_GE(parts.size(), 3U);
        EXPECT_GE(end.missed, int(parts.size()) - 2) << "of two halves the ray misses one";
        int held = 64;
        for (const PlaceEntered& part : parts) { // one within the other
            EXPECT_EQ(trace.objects[std::size_t(part.object)].name, "chain");
            EXPECT_LE(part.held, held);
            held = part.held;
            EXPECT_LE(part.low.x, 59);
            EXPECT_GE(part.high.x, 61);
            EXPECT_LE(part.t_in, 9.05);
            EXPECT_GE(part.t_out, 10.9);
        }
        EXPECT_LE(held, 8) << "a box around fewer balls saves nothing";
    }
}

TEST(SearchRecord, says_why_it_ended) {
    const Workbench bench = make_workbench(crowd());
    const auto stages = make_stages(bench, stage_choice("light"));
    int beyond = 0, nothing = 0, dark = 0;
    for (int x = 1; x < 64; x += 3)
        for (int y = 1; y < 48; y += 3)
            for (const TracedRay& ray : trace_pixel(bench, *stages, x, y).rays)
                for (const SearchEnded& end : all<SearchEnded>(ray)) {
                    beyond += end.reason == SearchEnd::beyond_reach ? 1 : 0;
                    nothing += end.reason == SearchEnd::nothing_left ? 1 : 0;
                    if (end.reason != SearchEnd::blocked && end.reason != SearchEnd::covered) continue;
                    ++dark;
                    EXPECT_EQ(ray.start().kind, RayKind::shadow);
                    EXPECT_EQ(ray.find<RayFinished>()->colour, Colour{0});
                }
    EXPECT_GT(beyond, 0);
    EXPECT_GT(nothing, 0);
    EXPECT_GT(dark, 0);
}

TEST(Extents, rectangles_hold_what_the_eye_sees_of_an_object) {
    const Workbench bench = make_workbench(crowd());
    const ScreenExtents extents = screen_extents(bench);
    ASSERT_EQ(extents.apart.size(), 1U); // the floor
    int seen = 0;
    for (int x = 0; x < 64; ++x)
        for (int y = 0; y < 48; ++y) {
            const Trace trace = trace_pixel(bench, x, y);
            const auto* hit = trace.rays[0].find<BoundaryChosen>();
            if (hit == nullptr) continue;
            const std::string& name = trace.objects[std::size_t(hit->object)].name;
            if (name == extents.apart[0]) continue;
            ++seen;
            const auto found = std::ranges::find(extents.rectangles, name, &ScreenExtents::Rectangle::name);
            ASSERT_NE(found, extents.rectangles.end());
            EXPECT_LE(found->left, x + 0.5);
            EXPECT_LE(found->top, y + 0.5);
            EXPECT_GE(found->right, x + 0.5);
            EXPECT_GE(found->bottom, y + 0.5);
            EXPECT_LE(found->nearest, hit->boundary.t);
            EXPECT_GE(extents.entries.at(x / extents.tile, y / extents.tile), 1);
        }
    EXPECT_GT(seen, 100);
}

} // namespace
} // namespace rayscope::test
