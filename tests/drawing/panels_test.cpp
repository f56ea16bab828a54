// No text covers another, none leaves its panel.

#include "tests/drawing/bowl.hpp"
#include "tests/support/scenes.hpp"
#include "visualizer/drawing/details_panel.hpp"
#include "visualizer/drawing/labels.hpp"
#include "visualizer/drawing/layout.hpp"
#include "visualizer/drawing/text.hpp"
#include "visualizer/drawing/timeline.hpp"
#include "visualizer/drawing/tree_panel.hpp"

#include <fmt/core.h>
#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

using namespace rayscope::drawing;

std::vector<Text> texts(const Canvas& canvas) {
    std::vector<Text> found;
    for (const Shape& shape : canvas.shapes)
        if (const auto* text = std::get_if<Text>(&shape)) found.push_back(*text);
    return found;
}

void expect_legible(const Canvas& canvas, const Area& panel, const std::string& which) {
    const auto all = texts(canvas);
    EXPECT_FALSE(all.empty()) << which;
    for (std::size_t i = 0; i < all.size(); ++i) {
        Area a = text_area(all[i]);
        a.y += all[i].size * 0.15; // lines may touch where no letter reaches
        a.height -= all[i].size * 0.3;
        EXPECT_TRUE(panel.contains(a)) << which << ": '" << all[i].text << "' leaves the panel";
        for (std::size_t j = 0; j < i; ++j) {
            Area b = text_area(all[j]);
            b.y += all[j].size * 0.15;
            b.height -= all[j].size * 0.3;
            EXPECT_FALSE(a.overlaps(b))
                << which << ": '" << all[i].text << "' covers '" << all[j].text << "'";
        }
    }
}

/// A name so long that it fits nowhere.
Workbench long_names() {
    Scene scene = bowl().scene;
    for (SceneCompound& compound : scene.compounds) compound.name.assign(300, 'W');
    for (SceneGeneric& generic : scene.generics) generic.name += std::string(200, 'i');
    return make_workbench(std::move(scene));
}

TEST(Panels, are_legible_in_every_size_for_every_ray) {
    const Workbench long_bench = long_names();
    const auto [x, y] = bowl().scene.step_pixel.value();
    for (const Trace& trace : {bowl_trace(), trace_pixel(long_bench, x, y), trace_pixel(bowl(), 0, 0)})
        for (const PictureSize size : {PictureSize{800, 450}, PictureSize{1280, 720}, PictureSize{480, 320}})
            for (int ray = 0; ray < int(trace.rays.size()); ray += 3) {
                const Lanes lanes = lanes_of(trace, trace.rays[std::size_t(ray)], most_lanes(size));
                const Layout layout = layout_of(size, trace, ray, true, lanes);
                const std::string which = fmt::format("{}, ray {}", size.width, ray);
                EXPECT_GT(layout.view.height, 0.35 * size.height) << which;
                Canvas tree, details, timeline;
                draw_tree(tree, layout.tree, trace, ray, layout.font);
                draw_details(details, layout.details, trace, ray, layout.font);
                draw_timeline(timeline, layout.timeline, lanes, trace, ray, layout.font);
                expect_legible(tree, layout.tree, fmt::format("{} tree", which));
                expect_legible(details, layout.details, fmt::format("{} details", which));
                expect_legible(timeline, layout.timeline, fmt::format("{} timeline", which));
            }
}

TEST(Panels, the_tree_shows_the_current_ray_and_counts_what_it_hides) {
    const Trace trace = bowl_trace();
    const int current = int(trace.rays.size()) / 2;
    Canvas canvas;
    draw_tree(canvas, {0, 0, 300, 160}, trace, current, 10);
    bool shown = false;
    int hidden = 0;
    std::size_t rows = 0;
    for (const Text& text : texts(canvas)) {
        shown |= text.text.starts_with(fmt::format("{} ", current));
        if (text.text.starts_with("…"))
            hidden += std::stoi(text.text.substr(std::string("… ").size()));
        else if (text.text.find(" → ") != std::string::npos || text.text.find(" ✗ ") != std::string::npos)
            ++rows;
    }
    EXPECT_TRUE(shown);
    EXPECT_EQ(rows + std::size_t(hidden), trace.rays.size());
}

TEST(Panels, labels_keep_off_each_other_and_stay_inside) {
    const Area area{0, 0, 400, 300};
    const std::vector<FlatSegment> strokes{{{0, 150}, {400, 150}}};
    LabelPlacer placer(area, strokes);
    Canvas canvas;
    int placed = 0;
    for (int i = 0; i < 60; ++i)
        placed += placer.place(canvas, {fmt::format("P{}", i), {150.0 + i % 5, 150.0 + i % 3}, ink}) ? 1 : 0;
    EXPECT_GT(placed, 5);
    const auto& taken = placer.taken();
    for (std::size_t i = 0; i < taken.size(); ++i) {
        EXPECT_TRUE(area.contains(taken[i]));
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(taken[i].overlaps(taken[j]));
    }
}

TEST(Panels, long_text_is_shortened_by_whole_characters) {
    const std::string text = fmt::format("Kürbis ∩ Größe − ℵ ∪ {:x>50}", "");
    for (double width = 5; width < 400; width += 7) {
        const std::string shorter = elided(text, Font::sans, 12, width);
        if (shorter != "…") {
            EXPECT_LE(text_width(shorter, Font::sans, 12), width);
        }
        for (std::size_t i = 0; i < shorter.size(); ++i) { // no character is cut in two
            const bool begins_character = static_cast<unsigned char>(shorter[i]) >= 0xC0U;
            ASSERT_FALSE(begins_character && i + 1 == shorter.size());
        }
    }
    EXPECT_EQ(elided("a\nb", Font::sans, 12, 100), "a b");
}

TEST(Timeline, starts_at_zero_unless_everything_is_far) {
    TracedRay ray;
    ray.events.emplace_back(RaySpawned{});
    BoundaryChosen hit;
    hit.boundary.t = 2;
    ray.events.emplace_back(hit);
    Lanes lanes;
    lanes.shown.push_back({0, 0, "ball", {}, true, {{{2}, {4}}}});
    const Window near = timeline_window(lanes, ray);
    EXPECT_LT(near.low, 0);
    EXPECT_GT(near.high, 4);
    lanes.shown[0].spans = {{{1002}, {1004}}};
    std::get<BoundaryChosen>(ray.events.back()).boundary.t = 1002;
    const Window far = timeline_window(lanes, ray);
    EXPECT_GT(far.low, 900);
    EXPECT_LT(far.low, 1002);
    EXPECT_GT(far.high, 1004);
    EXPECT_LT(far.high, 1100);
}

} // namespace
} // namespace rayscope::test
