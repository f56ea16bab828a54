// The order of events, and the ways through it.

#include "core/rayscope.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

const std::filesystem::path chapters = RAYSCOPE_SOURCE_DIR "/chapters";

// A hit, lit by a lamp behind a shadow ray (1), mirrored (2, with a shadow ray 3 of its own), and bent (4).
Trace small() {
    const auto start = [](RayKind kind, Id light = none) {
        RaySpawned e;
        e.kind = kind;
        e.light = light;
        return e;
    };
    LightLit lit;
    lit.light = 0;
    Trace trace;
    trace.lights.resize(1);
    trace.rays = {
        {none,
         {1, 2, 4},
         {start(RayKind::eye), BoundaryChosen{}, AmbientLit{}, lit, Reflected{}, Refracted{}, RayFinished{}}},
        {0, {}, {start(RayKind::shadow, 0), RayFinished{}}},
        {0, {3}, {start(RayKind::reflected), BoundaryChosen{}, AmbientLit{}, lit, RayFinished{}}},
        {2, {}, {start(RayKind::shadow, 0), RayFinished{}}},
        {0, {}, {start(RayKind::refracted), Missed{}, RayFinished{}}}};
    return trace;
}

std::vector<std::pair<int, int>> order(const Timeline& timeline) {
    std::vector<std::pair<int, int>> spots;
    for (std::size_t i = 0; i < timeline.size(); ++i)
        spots.emplace_back(timeline.at(i).ray, timeline.at(i).event);
    return spots;
}

TEST(Timeline, puts_the_events_of_spawned_rays_where_they_happened) {
    const Trace trace = small();
    const Timeline timeline(trace);
    EXPECT_EQ(order(timeline), (std::vector<std::pair<int, int>>{{0, 0},
                                                                 {0, 1},
                                                                 {0, 2},
                                                                 {1, 0},
                                                                 {1, 1},
                                                                 {0, 3},
                                                                 {0, 4},
                                                                 {2, 0},
                                                                 {2, 1},
                                                                 {2, 2},
                                                                 {3, 0},
                                                                 {3, 1},
                                                                 {2, 3},
                                                                 {2, 4},
                                                                 {0, 5},
                                                                 {4, 0},
                                                                 {4, 1},
                                                                 {4, 2},
                                                                 {0, 6}}));
    EXPECT_EQ(timeline.start(2), 7U);
    EXPECT_EQ(timeline.end(2), 13U);
    EXPECT_EQ(timeline.end(0), 18U);
}

TEST(Timeline, of_shipped_scenes_is_a_bijection_in_the_order_of_the_rays) {
    for (const char* scene :
         {"02_csg/glass_bowl.toml", "04_refraction/prism.toml", "03_reflection/mirror_room.toml"}) {
        const Workbench bench = open(chapters / scene);
        const Trace trace = trace_pixel(bench, 235, 250);
        const Timeline timeline(trace);
        std::size_t events = 0;
        for (const TracedRay& ray : trace.rays) events += ray.events.size();
        ASSERT_EQ(timeline.size(), events) << scene;
        for (std::size_t i = 0; i < timeline.size(); ++i)
            ASSERT_EQ(timeline.moment(timeline.at(i)), i) << scene;
        EXPECT_TRUE(std::ranges::is_sorted(timeline.rays())) << scene;
        EXPECT_EQ(timeline.end(0), events - 1);
    }
}

TEST(Timeline, of_a_full_record_starts_children_before_it_says_so) {
    Trace trace = small();
    trace.rays[0].events = {trace.rays[0].events[0], BoundaryChosen{}, Truncated{}, RayFinished{}};
    const Timeline timeline(trace);
    EXPECT_EQ(timeline.at(2), (Spot{1, 0}));
    EXPECT_EQ(timeline.at(timeline.size() - 2), (Spot{0, 2}));
}

class WalkSmall : public testing::Test {
protected:
    [[nodiscard]] std::pair<int, int> at() const {
        return {walk.cursor().spot().ray, walk.cursor().spot().event};
    }
    Walk walk{small()};
    Cursor& cursor = walk.cursor();
};
using At = std::pair<int, int>;

TEST_F(WalkSmall, steps_there_and_back) {
    std::vector<At> there{at()}, back;
    while (cursor.step() == Moved::yes) there.push_back(at());
    EXPECT_EQ(there.size(), walk.timeline().size());
    EXPECT_EQ(cursor.step(), Moved::at_end);
    back.push_back(at());
    while (cursor.step_back() == Moved::yes) back.push_back(at());
    std::ranges::reverse(back);
    EXPECT_EQ(there, back);
    EXPECT_EQ(cursor.step_back(), Moved::at_start);
}

TEST_F(WalkSmall, goes_from_ray_to_ray) {
    for (const int ray : {1, 2, 3, 4}) {
        EXPECT_EQ(cursor.next(), Moved::yes);
        EXPECT_EQ(at(), At(ray, 0));
    }
    EXPECT_EQ(cursor.next(), Moved::at_end);
    for (const int ray : {3, 2, 1, 0}) {
        EXPECT_EQ(cursor.back(), Moved::yes);
        EXPECT_EQ(at(), At(ray, 0));
    }
    EXPECT_EQ(cursor.back(), Moved::at_start);
    (void)cursor.go_to(Spot{2, 2});
    EXPECT_EQ(cursor.back(), Moved::yes);
    EXPECT_EQ(at(), At(2, 0)); // the latest start before
}

TEST_F(WalkSmall, goes_in_over_and_out) {
    EXPECT_EQ(cursor.over(), Moved::no_sibling);
    EXPECT_EQ(cursor.out(), Moved::no_parent);
    EXPECT_EQ(cursor.back_out(), Moved::no_parent);
    (void)cursor.in();
    EXPECT_EQ(at(), At(1, 0));
    EXPECT_EQ(cursor.in(), Moved::no_child);
    (void)cursor.over();
    EXPECT_EQ(at(), At(2, 0)); // past the shadow ray
    (void)cursor.in();
    EXPECT_EQ(at(), At(3, 0));
    (void)cursor.out();
    EXPECT_EQ(at(), At(2, 3)); // where ray 2 goes on
    (void)cursor.over();
    EXPECT_EQ(at(), At(2, 4));
    (void)cursor.over(); // its last event: out
    EXPECT_EQ(at(), At(0, 5));
    (void)cursor.over(); // past ray 4
    EXPECT_EQ(at(), At(0, 6));
    (void)cursor.back_into();
    EXPECT_EQ(at(), At(4, 2));
    (void)cursor.back_out();
    EXPECT_EQ(at(), At(0, 5)); // where it was about to be spawned
    (void)cursor.back_over();
    EXPECT_EQ(at(), At(0, 4));
    (void)cursor.go_to(Spot{4, 0});
    (void)cursor.back_over();
    EXPECT_EQ(at(), At(2, 0));
    (void)cursor.in();
    (void)cursor.out();
    (void)cursor.undo();
    EXPECT_EQ(at(), At(3, 0));
    (void)cursor.undo();
    EXPECT_EQ(at(), At(2, 0));
}

TEST_F(WalkSmall, goes_on_to_breakpoints_in_both_directions) {
    const int hits = walk.stops().add_breakpoint(Expression("hit"));
    EXPECT_EQ(walk.go_on(), Moved::yes);
    EXPECT_EQ(at(), At(0, 1));
    EXPECT_EQ(walk.reasons().at(0).number, hits);
    EXPECT_EQ(walk.go_on(), Moved::yes);
    EXPECT_EQ(at(), At(2, 1));
    EXPECT_EQ(walk.go_on(), Moved::at_end);
    EXPECT_EQ(at(), At(0, 6));
    EXPECT_EQ(walk.go_back(), Moved::yes);
    EXPECT_EQ(at(), At(2, 1));
    EXPECT_EQ(walk.stops().all().front().hits, 3);
    EXPECT_TRUE(walk.stops().enable(hits, false));
    EXPECT_EQ(walk.go_back(), Moved::at_start);
    EXPECT_EQ(at(), At(0, 0));
    EXPECT_FALSE(walk.stops().remove(7));
    EXPECT_TRUE(walk.stops().remove(hits));
}

TEST_F(WalkSmall, a_temporary_breakpoint_stops_once) {
    walk.stops().add_breakpoint(Expression("hit"), true);
    EXPECT_EQ(walk.go_on(), Moved::yes);
    EXPECT_TRUE(walk.stops().all().empty());
}

TEST_F(WalkSmall, a_watch_stops_where_its_value_becomes_another) {
    walk.stops().add_watch(Expression("kind"));
    std::vector<int> rays;
    while (walk.go_on() == Moved::yes) {
        rays.push_back(at().first);
        EXPECT_NE(walk.reasons().at(0).before, walk.reasons().at(0).now);
    }
    EXPECT_EQ(rays, (std::vector<int>{1, 0, 2, 3, 2, 0, 4, 0}));
}

TEST_F(WalkSmall, knows_where_another_run_parts) {
    walk.stops().add_breakpoint(Expression("divergence"));
    EXPECT_EQ(walk.go_on(), Moved::at_end);
    walk.set_divergence(Spot{2, 1});
    EXPECT_EQ(walk.go_back(), Moved::yes);
    EXPECT_EQ(at(), At(2, 1));
}

} // namespace
} // namespace rayscope::test
