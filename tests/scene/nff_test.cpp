#include "core/scene/read_nff.hpp"

#include "core/math/transform.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <regex>

namespace rayscope::nff {
namespace {

const std::string view = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 45\nhither 1\nresolution 64 48\n";
const std::string material = "f 1 0.5 0 0.8 0.2 10 0.3 1.5\n";

Scene parse(const std::string& text) { return parse_nff(text, "s.nff"); }

std::string error_of(const std::string& text) {
    try {
        (void)parse(text);
        return "no error";
    } catch (const InputError& error) {
        return error.what();
    }
}

Vec3d moved(const SceneGeneric& generic, const Vec3d& point) {
    const auto image = generic.matrix * glm::dvec4(point, 1);
    return {image.x, image.y, image.z};
}

TEST(SceneNff, ViewAndDefaults) {
    const Scene scene = parse("b 0.1 0.2 0.3\n" + view + material + "s 0 0 0 1\n");
    EXPECT_EQ(scene.background, Colour(0.1, 0.2, 0.3));
    EXPECT_EQ(scene.camera.eye, Vec3d(0, 0, 5));
    EXPECT_EQ(scene.camera.field_of_view, 45);
    EXPECT_EQ(scene.camera.width, 64);
    EXPECT_EQ(scene.camera.height, 48);
    EXPECT_EQ(scene.limits.max_depth, 4);
    EXPECT_EQ(scene.limits.min_weight, 0);
    EXPECT_TRUE(scene.shadows);
    EXPECT_TRUE(scene.warnings.empty());
    // Any order, and hither and resolution may be missing.
    EXPECT_EQ(parse("v up 0 1 0 angle 30 at 0 0 0 from 0 0 9").camera.width, 512);
}

TEST(SceneNff, Material) {
    const Scene scene = parse(view + material + "f 1 1 1 1 0 100000 0 0\nf 1 1 1 1 0 3 0 -1\n");
    const SceneMaterial& first = scene.materials[0];
    EXPECT_EQ(first.diffuse, Colour(0.8, 0.4, 0));
    EXPECT_EQ(first.specular, Colour(0.2));
    EXPECT_EQ(first.reflection, Colour(0.2));
    EXPECT_EQ(first.transmission, Colour(0.3));
    EXPECT_EQ(first.ambient, Colour(0));
    EXPECT_EQ(first.shininess, 10);
    EXPECT_EQ(first.speed, 1 / 1.5);
    EXPECT_EQ(scene.materials[1].speed, 1);
    EXPECT_EQ(scene.materials[2].speed, 1);
}

TEST(SceneNff, LightsWithoutColourShareTheirPower) {
    const Scene scene = parse(view + "l 1 2 3\nl 4 5 6 .5 +.5 5e-1\nl -1 0 0\nl 0 0 0\n");
    ASSERT_EQ(scene.lights.size(), 4U);
    EXPECT_EQ(scene.lights[0].position, Vec3d(1, 2, 3));
    EXPECT_EQ(scene.lights[0].colour, Colour(0.5));
    EXPECT_EQ(scene.lights[1].colour, Colour(0.5, 0.5, 0.5));
    EXPECT_EQ(scene.lights[3].colour, Colour(0.5));
}

TEST(SceneNff, ObjectsInTheOrderOfTheFile) {
    const Scene scene =
        parse(view + material + "s 1 2 3 0.5\n" + material + "p 3 0 0 0 1 0 0 0 1 0\ns 0 0 0 -2\n");
    ASSERT_EQ(scene.drawn.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(scene.drawn[i].index, i);
    EXPECT_EQ(moved(scene.generics[0], {1, 0, 0}), Vec3d(1.5, 2, 3));
    EXPECT_EQ(scene.generics[0].material, 0U);
    EXPECT_EQ(scene.generics[1].material, 1U);
    EXPECT_EQ(std::get<Polygon<double>>(scene.generics[1].shape).vertices()[1], Vec3d(1, 0, 0));
    EXPECT_EQ(moved(scene.generics[2], {0, 0, 1}), Vec3d(0, 0, 2)) << "seen from inside: the same surface";
}

TEST(SceneNff, PolygonsWithNormals) {
    const Scene scene = parse(view + material + "pp 3\n0 0 0 0 0 1\n1 0 0 0 1 1\n0 1 0 1 0 1\n");
    const auto& polygon = std::get<Polygon<double>>(scene.generics[0].shape);
    ASSERT_EQ(polygon.normals().size(), 3U);
    EXPECT_EQ(polygon.normals()[1], Vec3d(0, 1, 1));
}

// An arrow head: from its third corner all others are seen, from its first one they are not.
TEST(SceneNff, SmoothPolygonsThatAreNoFanAreCut) {
    const std::vector<Vec3d> corners{{2, -2, 0}, {0, 2, 0}, {-2, -2, 0}, {0, -1, 0}};
    const auto drawn = [&](std::size_t first) {
        std::string text = view + material + "pp 4\n";
        for (std::size_t i = 0; i < 4; ++i) {
            const Vec3d& p = corners[(first + i) % 4]; // its normal tells which corner it is
            text += fmt::format("{0} {1} 0  {0} {1} 5\n", p.x, p.y);
        }
        return parse(text).generics;
    };
    EXPECT_EQ(drawn(1).size(), 1U);
    EXPECT_EQ(drawn(3).size(), 1U);
    for (const std::size_t first : {0U, 2U}) {
        const auto triangles = drawn(first);
        ASSERT_EQ(triangles.size(), 2U);
        double area = 0;
        for (const SceneGeneric& triangle : triangles) {
            const auto& shape = std::get<Polygon<double>>(triangle.shape);
            ASSERT_EQ(shape.normals().size(), 3U);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(shape.normals()[i], shape.vertices()[i] + Vec3d(0, 0, 5));
            area += area_vector(shape.vertices()).z / 2;
        }
        EXPECT_EQ(area, 6);
    }
}

// Two walls that meet in an edge, the second bent by less than a thousandth of its size: as one polygon it would lie below
// the first one there, in its shadow.
TEST(SceneNff, PolygonsAreFlatAsFarAsSixDigitsCanSay) {
    const auto drawn = [](const std::string& fourth) {
        return parse(view + material + "p 4\n0 -1 0\n1 -1 " + fourth + "\n1 1 0\n0 1 0\n").generics.size();
    };
    EXPECT_EQ(drawn("0"), 1U);
    EXPECT_EQ(drawn("0.000004"), 1U);
    EXPECT_EQ(drawn("0.0004"), 2U);
    std::string round;
    for (int i = 0; i < 1100; ++i)
        round +=
            fmt::format("{} {} {}\n", std::cos(i * 0.005), std::sin(i * 0.005), 0.1 * std::sin(i * 0.015));
    const Scene scene = parse(view + material + "p 1100\n" + round);
    ASSERT_FALSE(scene.warnings.empty());
    EXPECT_NE(scene.warnings[0].find(", and of more than 1024 it is not cut; it is left out"),
              std::string::npos)
        << scene.warnings[0];
}

TEST(SceneNff, LinesEndInEveryWayAndAMarkMayComeFirst) {
    std::string text = "\xef\xbb\xbf# by an editor\n" + view + material + "s 0 0 0 1\nx\n";
    for (const std::string end : {"\n", "\r\n", "\r"}) {
        EXPECT_EQ(error_of(text), "s.nff:11:1: expected a command (b, v, l, f, c, s, p or pp), found 'x'")
            << end;
        text = std::regex_replace(text, std::regex("\r?\n"), end == "\n" ? "\r\n" : "\r");
    }
}

TEST(SceneNff, ConesRunFromBaseToApex) {
    const Scene scene =
        parse(view + material + "c 1 0 0 2\n1 4 0 0.5\nc 0 0 0 1 0 0 2 3\nc 0 0 0 1 2 2 1 1\n");
    const SceneGeneric& cone = scene.generics[0];
    EXPECT_EQ(std::get<OpenCone<double>>(cone.shape).top, 0.25);
    EXPECT_LT(length(moved(cone, {0, 0, -1}) - Vec3d(1, 0, 0)), 1e-15);
    EXPECT_LT(length(moved(cone, {0, 0, 1}) - Vec3d(1, 4, 0)), 1e-15);
    EXPECT_LT(std::abs(length(moved(cone, {1, 0, -1}) - Vec3d(1, 0, 0)) - 2), 1e-15);
    EXPECT_LT(std::abs(length(moved(cone, {0, 0.25, 1}) - Vec3d(1, 4, 0)) - 0.5), 1e-15);
    // The wider end becomes the base.
    const SceneGeneric& turned = scene.generics[1];
    EXPECT_EQ(std::get<OpenCone<double>>(turned.shape).top, 1.0 / 3);
    EXPECT_LT(length(moved(turned, {0, 0, -1}) - Vec3d(0, 0, 2)), 1e-15);
    const SceneGeneric& cylinder = scene.generics[2];
    EXPECT_TRUE(std::holds_alternative<OpenCylinder<double>>(cylinder.shape));
    EXPECT_LT(std::abs(length(moved(cylinder, {0.6, 0.8, 1}) - Vec3d(2, 2, 1)) - 1), 1e-15);
    EXPECT_LT(std::abs(dot(moved(cylinder, {1, 0, 0}) - moved(cylinder, {0, 0, 0}), Vec3d(2, 2, 1))), 1e-15);
}

TEST(SceneNff, OddObjectsAreLeftOutWithAWarning) {
    const Scene scene = parse(view + material +
                              "s 0 0 0 0\np 2 0 0 0 1 1 1\np 3 0 0 0 1 1 1 2 2 2\nc 0 0 0 1 0 0 0 1\n"
                              "c 0 0 0 0 0 0 1 0\n  s 0 0 0 1e-200\nf 1 1 1 .5 .5 3 .75 1\n");
    EXPECT_TRUE(scene.drawn.empty());
    const std::vector<std::string> expected{
        "s.nff:9:1: a sphere of radius 0 is left out",
        "s.nff:10:1: a polygon needs at least 3 vertices, found 2; it is left out",
        "s.nff:11:1: the polygon encloses no area: its vertices lie on one line, or it crosses itself; it is "
        "left out",
        "s.nff:12:1: a cone without length or radius is left out",
        "s.nff:13:1: a cone without length or radius is left out",
        "s.nff:14:3: a sphere of radius 1e-200 is left out",
        "s.nff:15:1: reflection + transmission is 1.25, more light than arrives",
        "s.nff:16:1: nothing is drawn: the scene has no objects"};
    EXPECT_EQ(scene.warnings, expected);
}

TEST(SceneNff, WarningsAreCapped) {
    std::string text = view + material + "s 0 0 0 1\n";
    for (int i = 0; i < 1000; ++i) text += "s 0 0 0 0\n";
    const Scene scene = parse(text);
    EXPECT_EQ(scene.warnings.size(), 21U);
    EXPECT_EQ(scene.warnings.back(), "s.nff: 980 more warnings of this kind");
}

TEST(SceneNff, Errors) {
    EXPECT_EQ(error_of(""), "s.nff:1:1: the file is empty, expected a scene");
    EXPECT_EQ(error_of("# only a comment"), "s.nff:1:17: the file is empty, expected a scene");
    EXPECT_EQ(error_of("b 0 0 0\n"),
              "s.nff:2:1: the file has no viewpoint: expected 'v' with from, at, up and angle");
    EXPECT_EQ(error_of("v\nfrom 0 0 0\nat 0 0 1\nup 0 1 0\n"), "s.nff:1:1: the viewpoint has no 'angle'");
    EXPECT_EQ(error_of("v from 0 0 0 at 0 0 0 up 0 1 0 angle 3"),
              "s.nff:1:1: 'from' and 'at' are the same point");
    EXPECT_EQ(error_of("v from 0 0 0 at 0 2 0 up 0 1 0 angle 3"),
              "s.nff:1:1: 'up' is parallel to the view from 'from' to 'at'");
    EXPECT_EQ(error_of("v\n angle 180"), "s.nff:2:8: expected an angle between 0 and 180 degrees, found 180");
    EXPECT_EQ(error_of("v\nresolution 0 1"),
              "s.nff:2:12: expected the width, an integer from 1 to 32768, found '0'");
    EXPECT_EQ(error_of("v\nresolution 32768 32768"), "s.nff:2:12: the resolution is more than 10^8 pixels");
    EXPECT_EQ(error_of("q 1 2 3\n"), "s.nff:1:1: expected a command (b, v, l, f, c, s, p or pp), found 'q'");
    EXPECT_EQ(error_of("# é\n é q\n"),
              "s.nff:2:2: expected a command (b, v, l, f, c, s, p or pp), found 'é'");
    EXPECT_EQ(error_of(view + "s 0 0 0 1\n"), "s.nff:8:1: expected a material (f) before the first object");
    EXPECT_EQ(error_of(view + material + "s 0 0 zero 1\n"),
              "s.nff:9:7: expected a sphere's coordinates, a number of at most 1e150 in size, found 'zero'");
    EXPECT_EQ(error_of(view + material + "s 0 0 0\n"), "s.nff:10:1: expected a sphere's radius, a number of "
                                                       "at most 1e150 in size, found the end of the file");
    EXPECT_EQ(error_of(view + material + "s 0 0 0 # 1\n s"),
              "s.nff:10:2: expected a sphere's radius, a number of at most 1e150 in size, found 's'");
    EXPECT_EQ(error_of(view + material + "p 1000001\n"),
              "s.nff:9:3: expected the number of vertices, an integer from 0 to 1000000, found '1000001'");
    EXPECT_EQ(error_of("f 1 -1 0 1 0 3 0 1"),
              "s.nff:1:5: expected a material's colour, not negative, found -1");
    EXPECT_EQ(error_of("f 1 1 0 1 0 3 0 1e9"),
              "s.nff:1:17: expected an index of refraction from 1e-06 to 1e+06, found 1e9");
}

TEST(SceneNff, NumbersThatAreNoNumbers) {
    for (const std::string number :
         {"nan", "inf", "-inf", "1e400", "1e151", "0x10", "1,5", "--1", "+-1", "1e", "+"})
        EXPECT_EQ(error_of("b " + number),
                  "s.nff:1:3: expected the background, a number of at most 1e150 in size, found '" + number +
                      "'");
    EXPECT_EQ(parse("b 1e-400 +1 .5 " + view).background, Colour(0, 1, 0.5));
}

// One line, so that columns would be quadratic if each were counted from its beginning.
TEST(SceneNff, LongLinesAreLinear) {
    std::string text = "v from 0 0 5 at 0 0 0 up 0 1 0 angle 45 f 1 1 1 1 0 3 0 1";
    for (int i = 0; i < 200000; ++i) text += " s 0 0 0 1";
    EXPECT_EQ(parse(text).generics.size(), 200000U);
}

// The databases' own files, where they are at hand.
TEST(SceneNff, StandardProceduralDatabases) {
    const char* folder = std::getenv("RAYSCOPE_SPD");
    if (folder == nullptr) GTEST_SKIP() << "RAYSCOPE_SPD names no folder";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".nff") continue;
        SCOPED_TRACE(entry.path().string());
        const Scene scene = read_nff(entry.path());
        EXPECT_FALSE(scene.drawn.empty());
        EXPECT_FALSE(scene.lights.empty());
        EXPECT_TRUE(scene.warnings.empty()) << scene.warnings.front();
        for (const SceneGeneric& generic : scene.generics) EXPECT_TRUE(is_invertible(generic.matrix));
        ++files;
    }
    EXPECT_GT(files, 0);
}

} // namespace
} // namespace rayscope::nff
