#include "visualizer/drawing/placed_names.hpp"

#include <gtest/gtest.h>

#include <random>

namespace rayscope::drawing {
namespace {

constexpr Area room{0, 0, 900, 500};

std::vector<Pixel> places_of(const std::vector<NamedMark>& names) {
    std::vector<Pixel> marks;
    for (const NamedMark& named : names) marks.push_back(named.at);
    return marks;
}

bool crosses(const std::vector<Pixel>& lead, const Area& area) {
    if (lead.empty()) return false;
    const double top = std::min(lead[0].y, lead[1].y), bottom = std::max(lead[0].y, lead[1].y);
    return Area{lead[0].x, top, 0.001, bottom - top}.overlaps(area);
}

TEST(PlacedNames, stand_beside_a_mark_that_is_alone) {
    const std::vector<NamedMark> names{{{200, 100}, "alone"}};
    const auto placed = place_names(names, places_of(names), {}, room);
    ASSERT_TRUE(placed[0]);
    EXPECT_TRUE(placed[0]->lead.empty());
    EXPECT_GT(placed[0]->area.x, 200);
}

TEST(PlacedNames, keep_apart_from_each_other_the_marks_and_the_line) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(20, 880), y(20, 480);
    for (int picture = 0; picture < 30; ++picture) {
        std::vector<NamedMark> names;
        for (int i = 0; i < 12; ++i)
            names.push_back({{x(random), i < 6 ? 250 : y(random)}, "name of mark " + std::to_string(i)});
        const std::vector<Pixel> marks = places_of(names), line{{20, 20}, {450, 300}, {880, 480}};
        const auto placed = place_names(names, marks, line, room);
        for (std::size_t i = 0; i < names.size(); ++i) {
            ASSERT_TRUE(placed[i]);
            EXPECT_TRUE(room.contains(placed[i]->area));
            for (std::size_t k = 0; k < names.size(); ++k) {
                EXPECT_FALSE(k != i && placed[i]->area.overlaps(placed[k]->area)) << picture;
                EXPECT_FALSE(k != i && crosses(placed[i]->lead, placed[k]->area)) << picture;
                EXPECT_FALSE(placed[i]->area.overlaps({marks[k].x - 4, marks[k].y - 4, 8, 8})) << picture;
            }
        }
    }
}

TEST(PlacedNames, that_find_no_room_are_left_out) {
    const std::vector<NamedMark> names{{{20, 10}, "much longer than the room is wide"}};
    EXPECT_FALSE(place_names(names, places_of(names), {}, {0, 0, 60, 20})[0]);
}

} // namespace
} // namespace rayscope::drawing
