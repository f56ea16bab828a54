// Faces that coincide. Rounding puts now one of them first and now the other, by the distance of the eye and by the
// matrices; no pixel may show which. Each scene is flat in colour if it is right.

#include "core/rayscope.hpp"
#include "core/scene/read_toml.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

namespace {

using namespace rayscope;

/// How often each colour occurs in the image of a scene that an eye at this distance sees 0.4 wide.
std::map<std::array<float, 3>, int> colours(const std::string& scene, double distance) {
    const double angle = 2 * std::atan(0.2 / distance) * 180 / std::numbers::pi;
    const Workbench bench =
        make_workbench(parse_toml(fmt::format("[camera]\neye = [0.13, 0.21, {}]\nlook_at = [0.03, 0.01, 0]\n"
                                              "field_of_view = {:.17g}\nresolution = [80, 80]\n{}",
                                              distance, angle, scene),
                                  "coincident.toml"));
    const Image image = render(bench).image;
    std::map<std::array<float, 3>, int> counts;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        ++counts[{image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}];
    return counts;
}

/// All pixels have one colour, whose red is `red` (negative: any but black).
void expect_one_colour(const std::string& scene, double distance, double red) {
    const auto found = colours(scene, distance);
    SCOPED_TRACE(fmt::format("distance {}\n{}", distance, scene));
    ASSERT_EQ(found.size(), 1U);
    if (red < 0)
        EXPECT_GT(found.begin()->first[0], 0);
    else
        EXPECT_NEAR(found.begin()->first[0], red, 1e-6);
}

constexpr std::array distances{5.0, 20.0, 100.0, 1000.0};
constexpr std::array scales{1.0, 0.7, 1.0 / 3};

// Failure: the secondary ray meets the other operand's face, ε beyond its start, and the solid shadows itself.
TEST(Coincident, FlushFacesOfAUnionCastNoShadowOnEachOther) {
    for (const double distance : distances)
        for (const double s : scales)
            expect_one_colour(
                fmt::format("[lights.l]\ndirection = [-0.3, -0.4, -1]\n[materials.m]\nambient = 0\n"
                            "[generics.a]\nshape = 'cube'\ntransform = [{{scale = {0}}}]\n"
                            "[generics.b]\nshape = 'cube'\ntransform = [{{scale = [{1}, {1}, {0}]}}]\n"
                            "[compounds.c]\nis = 'a | b'\nmaterial = 'm'\n",
                            s, s * 0.9),
                distance, -1);
}

// Failure: the entry into glass is counted twice, once for each operand.
TEST(Coincident, FlushFacesOfGlassAreOneBoundary) {
    for (const double distance : distances)
        for (const char* expression : {"a | b", "a & b"})
            expect_one_colour(
                fmt::format("[scene]\nbackground = 1\n[materials.m]\nambient = 0\ndiffuse = 0\n"
                            "transmission = 0.5\n"
                            "[generics.a]\nshape = 'cube'\ntransform = [{{scale = 0.7}}]\n"
                            "[generics.b]\nshape = 'cube'\ntransform = [{{scale = [0.6, 0.6, 0.7]}}]\n"
                            "[compounds.c]\nis = '{}'\nmaterial = 'm'\n",
                            expression),
                distance, 0.25);
}

/// A block of `upper` from z = −s to s that stands on one of `lower`, in the order given.
std::string stacked(const std::string& upper, const std::string& lower, double s, bool upper_first) {
    const std::string above = fmt::format("[generics.above]\nshape = 'cube'\nmaterial = 'upper'\n"
                                          "transform = [{{scale = {}}}]\n",
                                          s);
    const std::string below =
        fmt::format("[generics.below]\nshape = 'cube'\nmaterial = 'lower'\n"
                    "transform = [{{scale = [3, 3, {}]}}, {{translate = [0, 0, {:.17g}]}}]\n",
                    s, -2 * s);
    return "[scene]\nbackground = 1\n[materials.upper]\ndiffuse = 0\nambient = 0\n" + upper +
           "\n[materials.lower]\n" + lower + "\n" + (upper_first ? above + below : below + above);
}

// Failure: the refracted ray starts behind the table's top, inside the table, and never meets it.
TEST(Coincident, GlassOnATableShowsTheTable) {
    for (const double distance : {5.0, 50.0})
        for (const double s : scales)
            for (const bool glass_first : {true, false})
                expect_one_colour("[lights.l]\ndirection = [-0.3, -0.4, -1]\n" +
                                      stacked("transmission = 1\nindex = 1.5",
                                              "ambient = [0.5, 0, 0]\ndiffuse = [0.5, 0, 0]", s, glass_first),
                                  distance, 0.5 + 0.5 / std::sqrt(0.3 * 0.3 + 0.4 * 0.4 + 1));
}

// Failure: where two media touch, now the one's coefficient applies and now the other's.
TEST(Coincident, WhereMediaTouchTheFirstInTheFileHasTheBoundary) {
    for (const double s : scales)
        for (const bool glass_first : {true, false}) {
            const double twice_glass_once_water = 0.9 * 0.9 * 0.5, once_glass_twice_water = 0.9 * 0.5 * 0.5;
            expect_one_colour(stacked("transmission = 0.9\nindex = 1.5",
                                      "ambient = 0\ndiffuse = 0\ntransmission = 0.5\nindex = 1.33", s,
                                      glass_first),
                              5, glass_first ? twice_glass_once_water : once_glass_twice_water);
        }
}

// Failure: z-fighting.
TEST(Coincident, ACoincidentFaceOfTwoObjectsBelongsToTheFirstInTheFile) {
    for (const double s : {1.5, 3.0, 5.0, 6.0, 7.0, 10.0})
        for (const bool small_first : {true, false}) {
            const std::string small = "[generics.small]\nshape = 'cube'\nmaterial = 'small'\n";
            const std::string large =
                fmt::format("[generics.large]\nshape = 'cube'\nmaterial = 'large'\n"
                            "transform = [{{scale = {}}}, {{translate = [0, 0, {}]}}]\n",
                            s, 1 - s);
            expect_one_colour(
                "[materials.small]\ndiffuse = 0\nambient = 0.1\n[materials.large]\ndiffuse = 0\n"
                "ambient = 0.9\n" +
                    (small_first ? small + large : large + small),
                5, small_first ? 0.1 : 0.9);
        }
}

// Failure: of two polygons in one plane each shadows the other, in a pattern of noise.
TEST(Coincident, PolygonsInOnePlaneCastNoShadowOnEachOther) {
    const std::string corners = "vertices = [[-2, -2, 0.1], [2, -2, 0.1], [2, 2, 0.1], [-2, 2, 0.1]]\n";
    const std::string turned = "vertices = [[-3, -2, 0.1], [2, -3, 0.1], [3, 2, 0.1], [-2, 3, 0.1]]\n";
    expect_one_colour("[lights.l]\ndirection = [-0.3, -0.4, -1]\n[materials.m]\nambient = 0\n"
                      "[generics.a]\nshape = 'polygon'\nmaterial = 'm'\n" +
                          corners + "[generics.b]\nshape = 'polygon'\nmaterial = 'm'\n" + turned,
                      5, -1);
}

// Failure: the trace of neighbouring pixels names now one operand, now the other.
TEST(Coincident, AFlushFaceBelongsToTheLeftOperand) {
    const Workbench bench = make_workbench(parse_toml(
        "[camera]\neye = [0.3, 0.2, 5]\nlook_at = [0, 0, 0]\nfield_of_view = 4\nresolution = [40, 40]\n"
        "[materials.m]\n[generics.a]\nshape = 'cube'\ntransform = [{scale = 0.7}, {rotate_x = 20}]\n"
        "[generics.b]\nshape = 'cube'\n"
        "transform = [{scale = [0.6, 0.6, 0.35]}, {translate = [0, 0, 0.35]}, {rotate_x = 20}]\n"
        "[compounds.c]\nis = 'a | b'\nmaterial = 'm'\n",
        "owner.toml"));
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            const Trace trace = trace_pixel(bench, x, y);
            const auto* hit = trace.rays.front().find<BoundaryChosen>();
            ASSERT_NE(hit, nullptr);
            EXPECT_EQ(trace.generics[std::size_t(hit->boundary.leaf)], "a") << "pixel " << x << ", " << y;
        }
}

// Failure: the walls of a compound in a compound look like the outer one although they have a material of their own.
TEST(Coincident, AnOperandCompoundsMaterialLightsItsOwnWalls) {
    expect_one_colour(
        "[materials.inner]\ndiffuse = 0\nambient = 0.3\n[materials.outer]\ndiffuse = 0\nambient = 0.8\n"
        "[generics.a]\nshape = 'cube'\n[generics.b]\nshape = 'sphere'\n"
        "transform = [{translate = [0, 0, -4]}]\n[compounds.part]\nis = 'a'\nmaterial = 'inner'\n"
        "[compounds.whole]\nis = 'part | b'\nmaterial = 'outer'\n",
        5, 0.3);
}

} // namespace
