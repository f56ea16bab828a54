// What a right scene means: order, defaults, matrices, who is drawn.

#include "core/scene/read_toml.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace rayscope {
namespace {

Scene parse(std::string_view text) { return parse_toml(text, "s.toml"); }

std::vector<std::string> drawn(const Scene& scene) {
    std::vector<std::string> names;
    for (const SceneObject& object : scene.drawn)
        names.push_back(object.is_compound ? scene.compounds[object.index].name
                                           : scene.generics[object.index].name);
    return names;
}

using Names = std::vector<std::string>;

TEST(SceneToml, Defaults) {
    const Scene scene = parse("[materials.m]\n[lights.l]\nposition = [1, 2, 3]\n");
    EXPECT_EQ(scene.file, "s.toml");
    EXPECT_EQ(scene.camera.eye, Vec3d(0, 0, 5));
    EXPECT_EQ(scene.camera.look_at, Vec3d(0));
    EXPECT_EQ(scene.camera.up, Vec3d(0, 1, 0));
    EXPECT_EQ(scene.camera.field_of_view, 45);
    EXPECT_EQ(scene.camera.width, 512);
    EXPECT_EQ(scene.camera.height, 512);
    EXPECT_EQ(scene.background, Colour(0));
    EXPECT_EQ(scene.ambient, Colour(1));
    EXPECT_TRUE(scene.shadows);
    EXPECT_FALSE(scene.notes_media);
    EXPECT_EQ(scene.medium_speed, 1);
    EXPECT_EQ(scene.limits.max_depth, 8);
    EXPECT_EQ(scene.limits.min_weight, 0.001);
    EXPECT_FALSE(scene.step_pixel);
    EXPECT_EQ(scene.lights[0].colour, Colour(1));
    EXPECT_TRUE(scene.lights[0].shadows);
    EXPECT_EQ(scene.materials[0].speed, 1);
    EXPECT_EQ(scene.materials[0].diffuse, Colour(0.7));
    EXPECT_EQ(scene.warnings, Names{"s.toml: nothing is drawn: the scene has no visible solid"});
}

TEST(SceneToml, EverySection) {
    const Scene scene =
        read_toml(std::string(RAYSCOPE_SOURCE_DIR) + "/tests/fuzz/corpus/toml/everything.toml");
    EXPECT_EQ(scene.camera.eye, Vec3d(0, -4, 3));
    EXPECT_EQ(scene.camera.field_of_view, 40);
    EXPECT_EQ(scene.camera.width, 640);
    EXPECT_EQ(scene.camera.height, 480);
    EXPECT_EQ(scene.background, Colour(0.1, 0.2, 0.4));
    EXPECT_EQ(scene.ambient, Colour(0.5));
    EXPECT_EQ(scene.medium_speed, 1 / 1.33);
    EXPECT_EQ(scene.limits.max_depth, 6);
    EXPECT_EQ(scene.limits.min_weight, 0.01);
    EXPECT_EQ(scene.limits.max_rays, 5000);
    EXPECT_EQ(scene.step_pixel, std::pair(320, 200));
    ASSERT_EQ(scene.lights.size(), 2U);
    EXPECT_FALSE(scene.lights[0].directional);
    EXPECT_EQ(scene.lights[0].colour, Colour(1, 0.9, 0.8));
    EXPECT_TRUE(scene.lights[1].directional);
    EXPECT_FALSE(scene.lights[1].shadows);
    EXPECT_EQ(scene.lights[1].position, normalized(Vec3d(0, -1, 1))) << "towards the light";
    EXPECT_EQ(scene.materials[0].reflection, Colour(0.1));
    EXPECT_EQ(scene.materials[0].speed, 1 / 1.5);
    EXPECT_EQ(std::get<Cone<double>>(scene.generics[2].shape).top, 0.25);
    EXPECT_EQ(std::get<Torus<double>>(scene.generics[3].shape).minor, 0.1);
    EXPECT_EQ(std::get<Polygon<double>>(scene.generics[4].shape).vertices().size(), 4U);
    EXPECT_EQ(scene.generics[3].priority, 2);
    EXPECT_EQ(scene.compounds[3].priority, -1);
    EXPECT_EQ(scene.compounds[3].matrix[3][0], 3);
    EXPECT_EQ(drawn(scene), (Names{"ring", "ground", "other", "tower"}));
}

TEST(SceneToml, IntegersAreNumbersEvenWhereADoubleRoundsThem) {
    EXPECT_EQ(parse("camera.eye = [1, 0, 9007199254740993]").camera.eye, Vec3d(1, 0, 9007199254740992.0));
}

// The example of the reference page is what its reader copies.
TEST(SceneToml, DocumentedExample) {
    std::ifstream page(std::string(RAYSCOPE_SOURCE_DIR) + "/chapters/reference/scene-format.md");
    const std::string text{std::istreambuf_iterator<char>(page), {}};
    const auto begin = text.find("```toml\n") + 8;
    const auto end = text.find("```", begin);
    ASSERT_LT(end, text.size());
    const Scene scene = parse(text.substr(begin, end - begin));
    EXPECT_EQ(drawn(scene), (Names{"ground", "second_bowl"}));
    EXPECT_TRUE(scene.warnings.empty());
}

TEST(SceneToml, FileOrderIsTheOrderOfTies) {
    const Scene scene =
        parse("[materials.m]\n[generics.z]\nshape='sphere'\nmaterial='m'\n[compounds.y]\nis='b'\n"
              "material='m'\n[generics.b]\nshape='cube'\n[generics.a]\nshape='cube'\nmaterial='m'\n");
    EXPECT_EQ(drawn(scene), (Names{"z", "y", "a"}));
    EXPECT_EQ(scene.generics[0].name, "z");
    EXPECT_EQ(scene.generics[1].name, "b");
    EXPECT_EQ(scene.generics[2].name, "a");
    EXPECT_EQ(scene.generics[0].place.line, 2);
    EXPECT_EQ(scene.generics[0].place.column, 11);
}

TEST(SceneToml, OperandsAreDrawnOnlyWhereVisible) {
    const std::string head = "[materials.m]\n[generics]\na={shape='sphere',material='m'}\nb={shape='cube'}\n";
    EXPECT_EQ(drawn(parse(head + "[compounds]\nmaterial='m'\nc='a-b'\nd='c|a'\n")), Names{"d"});
    EXPECT_EQ(drawn(parse(head + "[compounds.c]\nis='a-b'\nmaterial='m'\nvisible=false\n")), Names{});
    EXPECT_EQ(drawn(parse(head + "[compounds.c]\nis='a-b'\nmaterial='m'\nvisible=true\n"
                                 "[compounds.d]\nis='!c'\nmaterial='m'\n")),
              (Names{"c", "d"}));
}

// An operand's material would change the light on its walls: the shared one goes only to what is drawn.
TEST(SceneToml, SharedMaterialIsForDrawnEquations) {
    const Scene scene =
        parse("[materials.m]\n[materials.n]\n[generics]\na={shape='sphere'}\nb={shape='cube'}\n"
              "[compounds]\nshell='a-b'\nbowl='shell-b'\nmaterial='n'\n"
              "[compounds.other]\nis='a'\nmaterial='m'\n");
    EXPECT_FALSE(scene.compounds[0].material);
    EXPECT_EQ(scene.compounds[1].material, 1U);
    EXPECT_EQ(scene.compounds[2].material, 0U);
}

TEST(SceneToml, ExpressionNodes) {
    const Scene scene = parse("[materials.m]\n[generics]\na={shape='sphere'}\nb={shape='cube'}\n"
                              "[compounds]\nmaterial='m'\nbowl='shell ∩ ¬b'\nshell=\"a - b\"\n");
    const SceneCompound& bowl = scene.compounds[0];
    EXPECT_EQ(bowl.expression, "shell ∩ ¬b");
    ASSERT_EQ(bowl.nodes.size(), 4U);
    EXPECT_TRUE(bowl.nodes[0].is_compound);
    EXPECT_EQ(bowl.nodes[0].operand, 1U);
    EXPECT_FALSE(bowl.nodes[1].is_compound);
    EXPECT_EQ(bowl.nodes[1].operand, 1U);
    EXPECT_EQ(bowl.nodes[2].operation, Operation::complement);
    EXPECT_EQ(bowl.nodes[2].left, 1U);
    EXPECT_EQ(bowl.nodes[3].operation, Operation::intersection);
    EXPECT_EQ(bowl.nodes[3].left, 0U);
    EXPECT_EQ(bowl.nodes[3].right, 2U);
    EXPECT_EQ(bowl.nodes[1].place.line, 7);
    EXPECT_EQ(bowl.nodes[1].place.column, 16);
    EXPECT_EQ(bowl.nodes[3].place.column, 13);
}

std::string numbered(std::string text, int i) { return text.append(std::to_string(i)); }

Vec3d moved(const std::string& steps, const Vec3d& point) {
    const Scene scene = parse("[generics.a]\nshape='cube'\nvisible=false\ntransform=" + steps);
    const auto image = scene.generics[0].matrix * glm::dvec4(point, 1);
    return {image.x, image.y, image.z};
}

TEST(SceneToml, TransformsApplyInTheOrderListed) {
    EXPECT_EQ(moved("[{translate=[1,0,0]},{scale=2}]", {1, 1, 1}), Vec3d(4, 2, 2));
    EXPECT_EQ(moved("[{scale=2},{translate=[1,0,0]}]", {1, 1, 1}), Vec3d(3, 2, 2));
    EXPECT_EQ(moved("[{rotate_z=90},{translate=[1,0,0]}]", {1, 0, 0}), Vec3d(1, 1, 0));
}

TEST(SceneToml, EachTransform) {
    EXPECT_EQ(moved("[]", {1, 2, 3}), Vec3d(1, 2, 3));
    EXPECT_EQ(moved("[{scale=[2,3,-4]}]", {1, 1, 1}), Vec3d(2, 3, -4));
    EXPECT_EQ(moved("[{rotate_x=90}]", {0, 1, 0}), Vec3d(0, 0, 1)) << "right-handed, exact";
    EXPECT_EQ(moved("[{rotate_y=90}]", {0, 0, 1}), Vec3d(1, 0, 0));
    EXPECT_EQ(moved("[{rotate_z=-270}]", {1, 0, 0}), Vec3d(0, 1, 0));
    EXPECT_EQ(moved("[{rotate=[0,0,7],angle=180}]", {1, 2, 3}), Vec3d(-1, -2, 3));
    EXPECT_LT(length(moved("[{rotate=[1,1,1],angle=120}]", {1, 0, 0}) - Vec3d(0, 1, 0)), 1e-15);
    EXPECT_EQ(moved("[{mirror='y'}]", {1, 2, 3}), Vec3d(1, -2, 3));
    EXPECT_EQ(moved("[{shear=[2,3,5,7,11,13]}]", {1, 10, 100}),
              Vec3d(1 + 20 + 300, 5 + 10 + 700, 11 + 130 + 100));
    EXPECT_EQ(moved("[{matrix=[[1,2,3,4],[0,1,0,5],[0,0,1,6],[0,0,0,1]]}]", {1, 1, 1}), Vec3d(10, 6, 7));
}

TEST(SceneToml, LongChainsOfCompoundsAreLinear) {
    std::string text = "[materials.m]\n[generics]\na={shape='sphere'}\n[compounds]\nmaterial='m'\nc0='a'\n";
    for (int i = 1; i < 20000; ++i) text += numbered("c", i) + numbered("='a-c", i - 1) + "'\n";
    EXPECT_EQ(parse(text).compounds.size(), 20000U);
}

// Many strings on one line: the columns must not be counted from its beginning each time.
TEST(SceneToml, LongLinesAreLinear) {
    std::string text = "generics={a={shape='sphere'}}\nmaterials={m={}}\ncompounds={material='m'";
    for (int i = 0; i < 50000; ++i) text += numbered(",c", i) + "='a - a'";
    const Scene scene = parse(text + "}\n");
    ASSERT_EQ(scene.compounds.size(), 50000U);
    EXPECT_EQ(scene.compounds.back().nodes[0].place.line, 3);
}

} // namespace
} // namespace rayscope
