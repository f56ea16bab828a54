// What the exported file says.

#include "core/povray/words.hpp"
#include "core/rayscope.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

#include <cstdlib>
#include <regex>

namespace rayscope::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

PovrayFile exported(const Workbench& bench) { return to_povray(bench.scene, bench.world); }
PovrayFile exported(const SceneBuilder& builder) { return exported(builder.open()); }

std::string without_comments(const std::string& text) {
    return std::regex_replace(text, std::regex("//[^\n]*"), "");
}

SceneBuilder with_a_ball() {
    SceneBuilder builder;
    builder.generic(Sphere<double>{}, Mat4d{1}, builder.glowing(Colour{1}), "ball");
    return builder;
}

TEST(PovrayExport, is_the_golden_file) {
    const std::filesystem::path folder = RAYSCOPE_SOURCE_DIR "/tests/povray/scenes";
    const std::string text = exported(open(folder / "small.toml")).text;
    if (std::getenv("RAYSCOPE_RENEW") != nullptr) write_text_file(folder / "small.pov", text);
    EXPECT_EQ(text, content_of(folder / "small.pov"));
}

TEST(PovrayExport, takes_every_shipped_scene) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYSCOPE_SOURCE_DIR "/chapters")) {
        if (entry.path().extension() != ".toml") continue;
        SCOPED_TRACE(entry.path().string());
        const Workbench bench = open(entry.path());
        const PovrayFile file = exported(bench);
        for (const std::string& difference : file.differences) {
            EXPECT_THAT(file.text, HasSubstr("// - " + difference + '\n'));
            EXPECT_THAT(difference, Not(HasSubstr("\n")));
        }
        EXPECT_THAT(file.text, Not(HasSubstr("nan")));
        EXPECT_THAT(without_comments(file.text), Not(HasSubstr("inf")));
        ++scenes;
    }
    EXPECT_GT(scenes, 10);
}

TEST(PovrayExport, numbers_are_read_back_as_they_were) {
    for (const double x : {0.1, 1.0 / 3, 1e-300, 123456789.123456789, -2.5, 0x1.fffffffffffffp+1023})
        EXPECT_EQ(std::stod(povray::number(x)), x);
    EXPECT_EQ(povray::number(-0.0), "0");
    EXPECT_THROW((void)povray::number(infinity<double>), std::range_error);
    EXPECT_EQ(povray::colour(Colour{0.5}), "rgb 0.5");
    EXPECT_EQ(povray::colour({0.5, 0.5, 1}), "rgb <0.5, 0.5, 1>");
}

TEST(PovrayExport, no_name_leaves_its_comment) {
    const auto text = [](const std::string& name) {
        SceneBuilder builder = with_a_ball();
        builder.light({0, 5, 0}).name = name;
        builder.scene().file = name;
        builder.scene().materials[0].name = name;
        builder.scene().generics[0].name = name;
        builder.operand(name, Cube<double>{});
        return exported(builder).text;
    };
    const std::string plain = without_comments(text("plain"));
    for (const std::string name :
         {"a\nlight_source { 0, rgb 9 }", "*/ sphere { 0, 9 } /*", "\r\n#error \"x\"", "\\", "a\xFF\xC2",
          "\xE2\x80\xA8sphere", "\"", "#declare rgb = 3;"})
        EXPECT_EQ(without_comments(text(name)), plain) << name;
}

TEST(PovrayExport, a_chain_of_one_operation_is_one_block) {
    SceneBuilder builder;
    for (const char* name : {"A", "B", "C"}) builder.operand(name, Sphere<double>{});
    const std::size_t material = builder.glowing(Colour{1});
    const auto blocks = [&](const std::string& expression) {
        SceneBuilder whole = builder;
        whole.compound("whole", expression, material);
        std::string text = exported(whole).text;
        text = without_comments(text.substr(text.find("\n// whole")));
        text = std::regex_replace(text, std::regex("sphere \\{[^}]*?, 1( |\\})"), "s$1");
        return std::regex_replace(text, std::regex("texture \\{[^}]*\\}|\\s+"), "");
    };
    EXPECT_EQ(blocks("A - B - C"), "difference{s}s}s}}");
    EXPECT_EQ(blocks("A | B | C"), "merge{s}s}s}}");
    EXPECT_EQ(blocks("A & B & C"), "intersection{s}s}s}}");
    EXPECT_EQ(blocks("A - (B - C)"), "difference{s}difference{s}s}}}");
    EXPECT_EQ(blocks("A & !B"), "intersection{s}sinverse}}");
    EXPECT_EQ(blocks("A & !!B"), "intersection{s}s}}");
    EXPECT_EQ(blocks("!(A | B)"), "merge{s}s}inverse}");
    EXPECT_EQ(blocks("!A"), "sinverse}");
}

TEST(PovrayExport, a_deep_tree_needs_no_deep_stack) {
    SceneBuilder builder;
    const std::size_t ball = builder.operand("A", Sphere<double>{});
    SceneCompound deep;
    deep.name = "deep";
    deep.material = builder.glowing(Colour{1});
    constexpr std::size_t levels = 50000;
    for (std::size_t i = 0; i <= levels; ++i) deep.nodes.push_back({Operation::leaf, 0, 0, false, ball, {}});
    for (std::size_t i = 0; i < levels; ++i) // A - (A - (… - A))
        deep.nodes.push_back({Operation::difference, i, i == 0 ? levels : levels + i, false, 0, {}});
    builder.scene().compounds.push_back(deep);
    builder.scene().drawn.push_back({true, 0});
    const std::string text = exported(builder).text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
}

TEST(PovrayExport, walls_of_glass_have_no_light_within) {
    SceneBuilder builder;
    const std::size_t glass = builder.clear(0.1, 0.9, 1.5);
    builder.operand("A", Sphere<double>{});
    const std::size_t own = builder.operand("B", Sphere<double>{});
    builder.scene().generics[own].material = builder.glowing(Colour{1});
    builder.compound("whole", "A - B", glass);
    builder.scene().medium_speed = 0.75;
    const std::string text = exported(builder).text;
    EXPECT_THAT(text, HasSubstr("sphere { <0, 0, 0>, 1 }\n"));
    EXPECT_THAT(text, HasSubstr("1 texture { Material_2 } interior_texture { Inside_2 } }\n"));
    EXPECT_THAT(text,
                HasSubstr("texture { Material_1 } interior_texture { Inside_1 } interior { ior 1.125 }"));
}

TEST(PovrayExport, one_pigment_serves_ambient_and_diffuse_light) {
    SceneBuilder builder;
    SceneMaterial material = SceneBuilder::dark();
    material.ambient = {0.25, 0, 0.5};
    material.diffuse = {0.5, 0.25, 0};
    builder.generic(Sphere<double>{}, Mat4d{1}, builder.material(material));
    EXPECT_THAT(exported(builder).text, HasSubstr("pigment { rgb <1, 0.5, 1.52587890625e-05> }\n"
                                                  "  finish { ambient rgb <0.25, 0, 32768> diffuse 0.5 }"));
}

TEST(PovrayExport, what_bends_nothing_counts_as_a_level) {
    SceneBuilder builder;
    builder.generic(Sphere<double>{}, Mat4d{1}, builder.clear(0, 1, 1));
    EXPECT_THAT(exported(builder).text, HasSubstr("interior { ior 1.0000001192092896 }"));
}

TEST(PovrayExport, limits_count_the_eye_ray) {
    SceneBuilder builder = with_a_ball();
    builder.scene().limits = {5, 0.25, 100000};
    EXPECT_THAT(exported(builder).text, HasSubstr("max_trace_level 6\n  adc_bailout 0.25\n"));
    EXPECT_THAT(exported(builder).differences, IsEmpty());
    Limits& limits = builder.scene().limits;
    limits.max_depth = 256;
    limits.min_weight = 0;
    limits.max_rays = 7;
    EXPECT_THAT(exported(builder).text, HasSubstr("max_trace_level 256\n"));
    EXPECT_THAT(exported(builder).differences,
                ElementsAre("max_depth 256 is cut to 255",
                            "max_rays 7 is left out: POV-Ray does not limit the rays of a pixel"));
}

TEST(PovrayExport, lights_without_shadows) {
    SceneBuilder builder = with_a_ball();
    builder.light({0, 5, 0}).shadows = false;
    EXPECT_THAT(exported(builder).text, HasSubstr(" no_shadow }"));
    EXPECT_THAT(exported(builder).text, Not(HasSubstr("shadowless")));
    EXPECT_THAT(exported(builder).differences, IsEmpty());
    builder.sun({0, 0, 1});
    EXPECT_THAT(exported(builder).text, Not(HasSubstr("no_shadow")));
    EXPECT_THAT(exported(builder).text, HasSubstr("light_source { <0, 5, 0>, rgb 1 shadowless }"));
    EXPECT_THAT(exported(builder).text, HasSubstr("rgb 1 parallel point_at 0 }"));
    EXPECT_THAT(exported(builder).differences,
                ElementsAre("light 'lamp' has no shadows, and so no highlights in POV-Ray"));
}

TEST(PovrayExport, says_what_povray_does_in_another_way) {
    SceneBuilder builder;
    SceneMaterial shiny = SceneBuilder::dark();
    shiny.name = "shiny";
    shiny.specular = {1, 0.5, 0};
    const std::size_t material = builder.material(shiny);
    builder.operand("block", Cube<double>{});
    Mat4d raised{0.5};
    raised[3] = {0, 0, 0.5, 1};
    builder.operand("hole", Cylinder<double>{}, raised);
    builder.compound("drilled", "block - hole", material);
    const std::size_t glass = builder.clear(0.25, 0.5, 1.5);
    builder.scene().materials[glass].name = "glass";
    Mat4d aside{1};
    aside[3] = {9, 0, 0, 1};
    builder.generic(Sphere<double>{}, aside, glass);
    aside[3] = {10, 0, 0, 1};
    builder.generic(Sphere<double>{}, aside, glass);
    const std::vector<Vec3d> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    builder.generic(Polygon<double>(corners, std::vector<Vec3d>(4, {0, 0, 1})), Mat4d{1}, material);
    EXPECT_THAT(
        exported(builder).differences,
        ElementsAre(
            "material 'shiny': the colour of its highlights is averaged to grey",
            "total reflection mirrors all light, not reflection + transmission (glass)",
            "where transparent solids overlap in part, the medium is the one that the ray entered last",
            "where a smooth polygon's normal turns away from the eye, POV-Ray turns it back, instead of "
            "taking "
            "the flat one",
            "compound 'drilled': 'block' and 'hole' have faces in one plane, where rounding decides, "
            "pixel by pixel, what POV-Ray sees"));
}

TEST(PovrayExport, scenes_are_moved_where_povray_would_lose_them) {
    const auto head = [](const Mat4d& matrix, const Vec3d& look_at, const Vec3d& eye) {
        SceneBuilder builder;
        builder.generic(Sphere<double>{}, matrix, builder.glowing(Colour{1}));
        builder.scene().camera.look_at = look_at;
        builder.scene().camera.eye = eye;
        const std::string text = exported(builder).text;
        std::smatch found;
        return std::regex_search(text, found, std::regex("// (Moved|Scaled) by [^:\n]*")) ? found.str() : "";
    };
    EXPECT_EQ(head(Mat4d{1}, {0, 0, 0}, {0, 0, 5}), "");
    Mat4d small{0.01};
    small[3][3] = 1;
    EXPECT_EQ(head(small, {0, 0, 0}, {0, 0, 0.1}), "// Scaled by 100");
    Mat4d far{1};
    far[3] = {1000000, 0, 0, 1};
    EXPECT_EQ(head(far, {1000000, 0, 0}, {1000000, 0, 5}), "// Moved by <-1000000, 0, 0>, to keep digits.");
    Mat4d large{1e8};
    large[3][3] = 1;
    EXPECT_EQ(head(large, {0, 0, 0}, {0, 0, 3e8}), "// Scaled by 0.001");
}

} // namespace
} // namespace rayscope::test
