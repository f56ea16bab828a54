// Guards against work for an effect that nothing calls for, and against a reason that names the wrong thing.

#include "core/scene/read_toml.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;

std::vector<EffectNeed> needs_of(const std::string& text) {
    const Workbench bench = make_workbench(parse_toml(text, "scene.toml"));
    return effect_needs(bench.scene, bench.world);
}
const EffectNeed& need(const std::vector<EffectNeed>& needs, Effect effect) {
    return needs.at(std::size_t(effect));
}

constexpr const char* everything = R"(
[camera]
eye = [0, -6, 2]
up = [0, 0, 1]
samples = 9
[lights.lamp]
position = [3, -3, 6]
sphere = 0.4
[materials.flint]
fresnel = true
index = 1.62
abbe = 36
absorption = [0.1, 0.2, 0.3]
[materials.floor]
diffuse = { checker = [1, 0.1], size = 0.5 }
specular = 0.3
[materials.mirror]
reflection = 0.5
[materials.unused]
transmission = 0.9
[generics.ball]
shape = "sphere"
material = "flint"
[generics.drop]
shape = "sphere"
material = "flint"
transform = [{ scale = 0.5 }]
[generics.ground]
shape = "plane"
material = "floor"
transform = [{ translate = [0, 0, -1] }]
[generics.wall]
shape = "plane"
material = "mirror"
transform = [{ rotate_x = 90 }, { translate = [0, 9, 0] }]
)";

TEST(Needs, of_a_scene_with_everything_name_who_calls) {
    const auto needs = needs_of(everything);
    for (const EffectNeed& n : needs)
        EXPECT_TRUE(n.needed) << effect_names[std::size_t(n.effect)].name << ": " << n.reason;
    EXPECT_THAT(need(needs, Effect::soft_shadows).reason, HasSubstr("'lamp'"));
    EXPECT_THAT(need(needs, Effect::soft_shadows).reason, HasSubstr("scene.toml:6"));
    EXPECT_THAT(need(needs, Effect::fresnel).reason, HasSubstr("material 'flint' of 'ball'"));
    EXPECT_THAT(need(needs, Effect::fresnel).reason, HasSubstr("scene.toml:9"));
    EXPECT_THAT(need(needs, Effect::patterns).reason, HasSubstr("'floor' of 'ground'"));
    EXPECT_THAT(need(needs, Effect::nested_media).reason, HasSubstr("'ball' and 'drop'"));
    EXPECT_THAT(need(needs, Effect::nested_media).reason, HasSubstr("scene.toml:21"));
    EXPECT_THAT(need(needs, Effect::antialiasing).reason, HasSubstr("9 samples"));
    EXPECT_THAT(need(needs, Effect::antialiasing).reason, HasSubstr("scene.toml:5"));
}

TEST(Needs, of_a_plain_scene_are_few_and_the_others_have_a_reason) {
    const auto needs = needs_of(R"(
[lights.lamp]
position = [3, 3, 6]
shadows = false
[materials.matt]
[materials.glass]
transmission = 0.9
[generics.ball]
shape = "sphere"
material = "matt"
)");
    EffectSet expected;
    expected.set(Effect::ambient).set(Effect::diffuse);
    EXPECT_EQ(needed_effects(needs), expected);
    for (const EffectNeed& n : needs) EXPECT_FALSE(n.reason.empty());
    EXPECT_THAT(need(needs, Effect::shadows).reason, HasSubstr("shadows = false"));
    EXPECT_THAT(need(needs, Effect::refraction).reason, HasSubstr("no drawn object transmits"));
}

TEST(Needs, of_lights_that_are_black_are_none) {
    std::string text = everything;
    text.insert(text.find("[materials.flint]"), "colour = 0\n");
    text.insert(0, "[limits]\nmax_depth = 0\n");
    const Workbench bench = make_workbench(parse_toml(text, "scene.toml"));
    const auto needs = effect_needs(bench.scene, bench.world);
    for (const Effect effect : {Effect::diffuse, Effect::specular, Effect::shadows})
        EXPECT_THAT(need(needs, effect).reason, HasSubstr("no light shines"));
    EXPECT_FALSE(need(needs, Effect::soft_shadows).needed);
    EXPECT_THAT(need(needs, Effect::dispersion).reason, HasSubstr("max_depth is 0"));
    RenderOptions options;
    options.width = options.height = 16;
    EXPECT_EQ(render(bench, options).statistics.counters.rays[std::size_t(RayKind::shadow)], 0U);
}

TEST(Needs, of_a_formula_that_gives_all_colours_one_index_is_no_dispersion) {
    const auto with = [](const std::string& formula) {
        std::string text = everything;
        text.replace(text.find("index = 1.62\nabbe = 36"), 22, formula);
        return text;
    };
    EXPECT_FALSE(need(needs_of(with("sellmeier = [1.25, 0, 0, 0, 0, 0]")), Effect::dispersion).needed);
    EXPECT_TRUE(need(needs_of(with("sellmeier = [1.25, 0, 0, 0.01, 0, 0]")), Effect::dispersion).needed);
    // Between two of the places at which the index is looked at.
    try {
        (void)needs_of(with("sellmeier = [1.25, 1e-2, 0, 0.01, 0.2509, 1]"));
        ADD_FAILURE() << "a pole within the spectrum";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("a term of the formula is infinite at 500.899 nm: expected √C outside "
                              "of 400 to 700 nm"));
    }
}

TEST(Needs, a_wall_inside_a_compound_is_no_medium) {
    const auto needs = needs_of(R"(
[materials.stone]
[materials.glass]
transmission = 0.9
[generics.ball]
shape = "sphere"
[generics.hole]
shape = "cylinder"
material = "glass"
[compounds.block]
is = "ball - hole"
material = "stone"
)");
    EXPECT_FALSE(need(needs, Effect::refraction).needed);
}

// A scene in which nothing can come of it.
void expect_unneeded(Effect effect, const std::string& text) {
    const auto needs = needs_of(text);
    EXPECT_FALSE(need(needs, effect).needed) << need(needs, effect).reason;
}

TEST(Needs, of_what_can_not_show_are_none) {
    const std::string lamp = "[lights.lamp]\nposition = [3, 3, 6]\nsphere = 1\n";
    const std::string ball = "[generics.ball]\nshape = \"sphere\"\nmaterial = \"m\"\n";
    const std::string sheet =
        "[generics.sheet]\nshape = \"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, "
        "0]]\nmaterial = \"m\"\n";
    const std::string mirror = "[materials.m]\nambient = 0\ndiffuse = 0\nreflection = 0.9\n";
    expect_unneeded(Effect::soft_shadows, lamp + mirror + ball);
    expect_unneeded(Effect::patterns,
                    "[scene]\nambient = 0\n[materials.m]\nambient = { checker = [1, 0.2] }\n" + ball);
    expect_unneeded(Effect::patterns, "[materials.m]\ndiffuse = { checker = [1, 0.2] }\n" + ball);
    expect_unneeded(Effect::patterns, "[materials.m]\n[materials.o]\nreflection = { checker = [0.5, 0] "
                                      "}\n[generics.a]\nshape = \"sphere\"\nmaterial = "
                                      "\"o\"\n[generics.b]\nshape = \"cube\"\n[compounds.c]\nis = \"a & "
                                      "b\"\nmaterial = \"m\"\n");
    const std::string sooty = "[materials.m]\ntransmission = 0.5\nindex = 1.5\nabbe = 30\nabsorption = 1\n";
    expect_unneeded(Effect::absorption, sooty + sheet);
    expect_unneeded(Effect::dispersion, sooty + sheet);
    const std::string two_glasses = "[materials.m]\nfresnel = true\nindex = 1.5\nabsorption = 1\n" + ball +
                                    "[generics.box]\nshape = \"cube\"\nmaterial = \"m\"\n";
    const std::string still = "[camera]\neye = [0, 0, 9]\n[limits]\nmax_depth = 0\n" + two_glasses;
    for (const Effect effect : {Effect::nested_media, Effect::fresnel, Effect::absorption})
        expect_unneeded(effect, still);
    expect_unneeded(Effect::fresnel,
                    "[materials.m]\n[materials.unused]\nfresnel = true\nindex = 1.5\n" + ball);
}

TEST(Needs, of_materials_that_nothing_drawn_has_leave_the_tracer_the_classic_one) {
    const std::string ball = "[generics.ball]\nshape = \"sphere\"\nmaterial = \"m\"\n";
    const auto mask = [](const std::string& text) {
        return make_workbench(parse_toml(text, "scene.toml")).world.effects;
    };
    EXPECT_EQ(mask("[materials.m]\n[materials.unused]\nfresnel = true\nindex = 1.5\n" + ball),
              EffectMask::classic);
    EXPECT_EQ(mask("[materials.m]\nfresnel = true\nindex = 1.5\n" + ball), EffectMask::all);
    const std::string sheet =
        "[materials.m]\ntransmission = 0.5\nabsorption = 1\n[generics.sheet]\nshape = "
        "\"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nmaterial = \"m\"\n";
    EXPECT_EQ(mask(sheet), EffectMask::classic);
}

TEST(Needs, of_a_fresnel_mirror_are_so_also_where_it_is_a_sheet) {
    const auto needs =
        needs_of("[materials.m]\nfresnel = true\nindex = 1.5\n[generics.sheet]\nshape = "
                 "\"triangle\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nmaterial = \"m\"\n");
    EXPECT_TRUE(need(needs, Effect::fresnel).needed);
}

TEST(Needs, of_reflection_leave_total_reflection_to_refraction) {
    const auto needs = needs_of("[materials.m]\ntransmission = 0.9\nindex = 1.5\n[generics.ball]\nshape = "
                                "\"sphere\"\nmaterial = \"m\"\n");
    EXPECT_THAT(need(needs, Effect::reflection).reason, HasSubstr("belongs to refraction"));
}

TEST(Rays, of_a_kind_that_nothing_calls_for_are_exactly_none) {
    SceneBuilder b;
    SceneMaterial matt; // diffuse and ambient
    b.light({2, 3, 6});
    b.generic(Sphere<double>{}, Mat4d{1}, b.material(matt), "ball");
    b.scene().lights[0].shadows = false;
    b.scene().camera.width = b.scene().camera.height = 64;
    for (const bool all : {false, true}) {
        RenderOptions options;
        options.all_effects = all;
        const auto rays = render(b.open(), options).statistics.counters.rays;
        EXPECT_EQ(rays[std::size_t(RayKind::eye)], 64U * 64U);
        EXPECT_EQ(rays[std::size_t(RayKind::shadow)], 0U);
        EXPECT_EQ(rays[std::size_t(RayKind::reflected)], 0U);
        EXPECT_EQ(rays[std::size_t(RayKind::refracted)], 0U);
    }
}

TEST(Words, are_a_list_or_changes_never_both) {
    EffectSet needed;
    needed.set(Effect::shadows).set(Effect::refraction);
    EXPECT_EQ(parse_effects("auto", needed), needed);
    EffectSet only;
    only.set(Effect::fresnel);
    EXPECT_EQ(parse_effects("fresnel", needed), only);
    EffectSet changed;
    changed.set(Effect::refraction).set(Effect::fresnel);
    EXPECT_EQ(parse_effects("+fresnel,-shadows", needed), changed);
    for (const char* wrong :
         {"", "+", "fresnel,", "+fresnel,shadows", "fresnel,-shadows", "frensel", "+auto", ","})
        EXPECT_THROW(static_cast<void>(parse_effects(wrong, needed)), std::invalid_argument) << wrong;
    try {
        static_cast<void>(parse_effects("+frensel", needed));
    } catch (const std::invalid_argument& error) {
        EXPECT_THAT(error.what(), HasSubstr("did you mean 'fresnel'?"));
    }
}

TEST(Scene, says_by_a_complete_list_what_is_simulated) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "chosen_effects.toml";
    write_text_file(path, R"(
[scene]
effects = ["ambient", "diffuse", "refraction", "fresnel"]
[lights.lamp]
position = [3, 3, 6]
[materials.glass]
transmission = 0.9
index = 1.5
[generics.ball]
shape = "sphere"
material = "glass"
)");
    const Workbench bench = open(path);
    EXPECT_FALSE(bench.scene.lights[0].shadows);
    EXPECT_EQ(bench.scene.materials[0].mirror, Mirror::fresnel);
    EXPECT_THAT(bench.scene.warnings,
                testing::Contains(HasSubstr("not simulated, as it was asked: shadows")));
    EXPECT_THAT(bench.scene.warnings,
                testing::Contains(HasSubstr("nothing in the scene calls for it: fresnel")));
    const auto needs = effect_needs(bench.scene, bench.world);
    EXPECT_EQ(needs[std::size_t(Effect::shadows)].reason, "taken away, as it was asked");
    EXPECT_EQ(needs[std::size_t(Effect::fresnel)].reason, "added, as it was asked");
    EXPECT_THAT(open(path, "+dispersion,-refraction").scene.warnings,
                testing::Contains(HasSubstr("there is nothing in the scene to add it to: dispersion")));
    // The command's word is the last one.
    EXPECT_TRUE(open(path, "auto").scene.lights[0].shadows);
}

} // namespace
} // namespace rayscope::test
