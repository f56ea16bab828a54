// Whoever looks at a figure can read it: no text lies over another one, beyond the page, or below a size.

#include "tests/figures/svg_marks.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/figures/catalogue.hpp"

#include <gtest/gtest.h>

namespace rayscope::figures {
namespace {

namespace fs = std::filesystem;

/// Widths are a font's own, rounded to a pixel of letters 32 high: so they may be off by 1/32 of a letter's size.
constexpr double slack = 1;

struct Figure {
    std::string name;
    SvgMarks marks;
};

/// Every SVG below chapters/, whether the catalogue knows it or not.
const std::vector<Figure>& all_figures() {
    static const std::vector<Figure> figures = [] {
        std::vector<Figure> list;
        for (const auto& entry : fs::recursive_directory_iterator(fs::path(RAYSCOPE_SOURCE_DIR) / "chapters"))
            if (entry.path().extension() == ".svg")
                list.push_back({entry.path().stem().string(), marks_of(test::content_of(entry.path()))});
        return list;
    }();
    return figures;
}

TEST(Layout, knows_all_figures) {
    EXPECT_EQ(all_figures().size(), read_catalogue().size());
    for (const Figure& figure : all_figures()) {
        EXPECT_GT(figure.marks.page.width, 0) << figure.name;
        EXPECT_FALSE(figure.marks.texts.empty()) << figure.name;
    }
}

TEST(Layout, no_text_lies_over_another) {
    for (const auto& [name, marks] : all_figures())
        for (std::size_t i = 0; i < marks.texts.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_FALSE(shrunk(marks.texts[i].area, slack).overlaps(shrunk(marks.texts[k].area, slack)))
                    << name << ": '" << marks.texts[k].words << "' and '" << marks.texts[i].words << "'";
}

TEST(Layout, all_text_is_on_the_page) {
    for (const auto& [name, marks] : all_figures())
        for (const PlacedText& text : marks.texts)
            EXPECT_TRUE(marks.page.contains(shrunk(text.area, slack))) << name << ": '" << text.words << "'";
}

/// A page of text is about 800 pixels wide on a screen: 17 of 1000 units are 14 pixels.
TEST(Layout, letters_are_large_enough) {
    for (const auto& [name, marks] : all_figures())
        for (const PlacedText& text : marks.texts)
            EXPECT_GE(text.size * 1000 / marks.page.width, 17) << name << ": '" << text.words << "'";
}

TEST(Layout, nothing_is_drawn_over_a_text) {
    for (const auto& [name, marks] : all_figures())
        for (const PlacedText& text : marks.texts)
            for (const Cover& cover : marks.covers)
                EXPECT_FALSE(cover.order > text.order && cover.area.overlaps(shrunk(text.area, slack)))
                    << name << ": '" << text.words << "'";
}

/// What passes within a fifth of the letters' size from the edge of their room does not strike them through.
TEST(Layout, no_line_goes_through_a_text) {
    for (const auto& [name, marks] : all_figures())
        for (const PlacedText& text : marks.texts) {
            const drawing::Area letters = shrunk(text.area, text.size / 5);
            for (const DrawnLine& line : marks.lines) {
                const bool crosses = drawing::length_within(line.from, line.to, letters) > slack;
                EXPECT_FALSE(crosses && !is_covered(marks, letters, line.order, text.order))
                    << name << ": a line from (" << line.from.x << ", " << line.from.y << ") to ("
                    << line.to.x << ", " << line.to.y << ") through '" << text.words << "'";
            }
        }
}

} // namespace
} // namespace rayscope::figures
