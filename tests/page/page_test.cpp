// The page as a file: what is in it, and how large it is. Its behaviour in a browser: browser_test.mjs.

#include "tests/support/scenes.hpp"
#include "visualizer/page/page.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string content(const std::string& page, const std::string& id) {
    const std::string opening = "<script type=\"application/json\" id=\"" + id + "\">";
    const auto begin = page.find(opening) + opening.size();
    return page.substr(begin, page.find("</script>", begin) - begin);
}

std::vector<std::filesystem::path> shipped_scenes() {
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(RAYSCOPE_SOURCE_DIR "/chapters"))
        if (entry.path().extension() == ".toml") scenes.push_back(entry.path());
    return scenes;
}

TEST(Page, of_every_shipped_scene_is_small_and_holds_exactly_the_trace) {
    int count = 0;
    for (const auto& scene : shipped_scenes()) {
        const Workbench bench = open(scene);
        const auto [x, y] = bench.scene.step_pixel.value_or(
            std::pair(bench.scene.camera.width / 2, bench.scene.camera.height / 2));
        const Trace trace = trace_pixel(bench, x, y);
        const std::string page = page::page_text(bench, trace);
        EXPECT_LT(page.size(), 400'000U) << scene;
        EXPECT_EQ(nlohmann::json::parse(content(page, "trace")), to_json(trace)) << scene;
        const auto around = nlohmann::json::parse(content(page, "scene"));
        EXPECT_FALSE(around["surfaces"].empty()) << scene;
        EXPECT_EQ(around["left_out"], 0) << scene;
        ++count;
    }
    EXPECT_GE(count, 12);
}

TEST(Page, asks_nothing_of_a_network) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
    const std::string page = page::page_text(bench, trace_pixel(bench, 240, 240));
    EXPECT_THAT(page, HasSubstr("default-src 'none'"));
    for (const char* word :
         {"https:", "src=", "url(", "import(", "fetch(", "XMLHttpRequest", "innerHTML", "eval("})
        EXPECT_THAT(page, Not(HasSubstr(word))) << word;
    EXPECT_EQ(page.find("http:"), page.find("http://www.w3.org/2000/svg")); // a name, not an address
    for (const char* mark : {"@STYLE@", "@TRACE@", "@SCENE@", "@SCRIPT@"})
        EXPECT_THAT(page, Not(HasSubstr(mark)));
}

TEST(Page, lets_no_name_out_of_its_element) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
    Trace trace = trace_pixel(bench, 240, 240);
    const std::string hostile = "</script><img src=x onerror=alert(1)><!--<script>@SCENE@ \xE2\x80\xA8 \"'";
    trace.objects[0].name = trace.source.scene = trace.lights[0].name = trace.media[0].name = hostile;
    const std::string page = page::page_text(bench, trace);
    EXPECT_THAT(page, Not(HasSubstr("<img")));
    EXPECT_EQ(nlohmann::json::parse(content(page, "trace")), to_json(trace));
    EXPECT_TRUE(nlohmann::json::accept(content(page, "scene")));
}

TEST(Page, surfaces_lie_on_the_solids_that_they_show) {
    // (a ball − a smaller one) ∩ a half space: corners lie on the compound's border, and only there.
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    const std::string page = page::page_text(bench, trace_pixel(bench, 235, 250));
    const auto around = nlohmann::json::parse(content(page, "scene"));
    const auto bowl =
        std::ranges::find_if(around["surfaces"], [](const auto& s) { return s["name"] == "bowl"; });
    ASSERT_NE(bowl, around["surfaces"].end());
    const Box<double>& bounds = bench.world.objects[0].bounds;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = (*bowl)["low"][std::size_t(axis)], high = (*bowl)["high"][std::size_t(axis)];
        EXPECT_GE(low, bounds.low[axis] - 1e-5);
        EXPECT_LE(high, bounds.high[axis] + 1e-5);
        EXPECT_GT(high - low, 0.8 * (bounds.high[axis] - bounds.low[axis]));
    }
}

TEST(Page, of_a_ray_that_meets_nothing_is_whole) {
    SceneBuilder builder;
    const Workbench bench = make_workbench(std::move(builder.scene()));
    const Trace trace = trace_ray(bench, {{0, 0, 0}, {0, 0, -1}});
    const auto around = nlohmann::json::parse(content(page::page_text(bench, trace), "scene"));
    EXPECT_TRUE(around["surfaces"].empty());
    EXPECT_GT(around["radius"], 0);
}

} // namespace
} // namespace rayscope::test
