// rayscope render and trace: files, whole or not at all.

#include "core/rayscope.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace rayscope::test {
namespace {

using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(Render, ends_with_the_path_and_says_what_it_did) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program({"render", "glass_bowl", "-o", "bowl.png", "--size", "40x30"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("rays    eye 1 200, reflected "));
    EXPECT_THAT(outcome.out, HasSubstr("image   40 × 30 pixels"));
    EXPECT_THAT(outcome.out, EndsWith("\nbowl.png\n"));
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_EQ(folder.names(), std::vector<std::string>{"bowl.png"});
}

TEST(Render, any_number_of_threads_gives_the_same_bytes) {
    const TemporaryFolder folder;
    for (const char* threads : {"1", "2", "7"}) {
        const std::string name = std::string(threads) + ".exr";
        EXPECT_EQ(run_program({"render", "glass_bowl", "-o", name, "--size", "64x48", "--threads", threads},
                              {folder.path()})
                      .code,
                  0);
        EXPECT_EQ(content_of(folder.path() / name), content_of(folder.path() / "1.exr")) << threads;
    }
}

TEST(Render, an_octree_tells_where_it_stops_to_divide_and_why) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program(
        {"render", "crowd", "-o", "c.pfm", "--size", "40x30", "--stage", "octree", "--stats", "s.json"},
        {folder.path()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("\noctree  "));
    const json octree = json::parse(content_of(folder.path() / "s.json")).at("stage").at("octree");
    EXPECT_GT(octree.at("leaves"), 8);
    EXPECT_GT(octree.at("entries"), octree.at("leaves"));
    for (const char* limit : {"depth", "capacity", "least_size"}) {
        EXPECT_GT(octree.at("limits").at(limit).at("value"), 0) << limit;
        const std::string reason = octree.at("limits").at(limit).at("reason");
        EXPECT_THAT(outcome.out, HasSubstr(": " + reason + "\n")) << limit;
    }
}

TEST(Render, an_octree_of_nothing_says_that_nothing_fits_into_it) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "endless.toml")
        << "[materials.grey]\n[generics.ground]\nshape = \"plane\"\nmaterial = \"grey\"\n";
    const Outcome outcome = run_program(
        {"render", "endless.toml", "-o", "e.pfm", "--size", "8x6", "--stage", "octree", "--stats", "s.json"},
        {folder.path()});
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                HasSubstr("\noctree  none: no object fits into a cell\n        1 in no cell: without end"));
    const json octree = json::parse(content_of(folder.path() / "s.json")).at("stage").at("octree");
    EXPECT_EQ(octree.at("limits").at("depth").at("reason"), "no object fits into a cell");
}

TEST(Render, statistics_have_the_documented_members) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"render", "glass_bowl", "-o", "b.pfm", "--size", "40x30", "--stats", "s.json"},
                          {folder.path()})
                  .code,
              0);
    const json statistics = json::parse(content_of(folder.path() / "s.json"));
    EXPECT_EQ(statistics.at("format"), "rayscope-statistics");
    EXPECT_EQ(statistics.at("version"), 1);
    EXPECT_EQ(statistics.at("image").at("width"), 40);
    EXPECT_EQ(statistics.at("rays").at("eye"), 1200);
    EXPECT_GT(statistics.at("tests").at("sphere"), 1200);
    EXPECT_GT(statistics.at("compounds"), 0);
    EXPECT_GT(statistics.at("peak_memory_bytes"), 1 << 20);
    for (const char* phase : {"load", "build", "trace", "write"}) {
        EXPECT_GE(statistics.at("seconds").at(phase).at("cpu"), 0);
        EXPECT_GT(statistics.at("seconds").at(phase).at("wall"), 0);
    }
    for (const char* limit : {"depth", "weight", "max_rays"})
        EXPECT_TRUE(statistics.at("cut").contains(limit));

    // The page names each member, and no more.
    const std::string page = content_of(RAYSCOPE_SOURCE_DIR "/chapters/reference/render-statistics.md");
    for (const auto& [member, value] : statistics.items())
        EXPECT_THAT(page, testing::AnyOf(HasSubstr("`" + member + "`"), HasSubstr("`" + member + ".")))
            << member;
}

TEST(Render, the_image_is_that_of_the_library) {
    const TemporaryFolder folder;
    ASSERT_EQ(run_program({"render", "glass_bowl", "-o", "b.pfm", "--size", "40x30", "--stats", "s.json"},
                          {folder.path()})
                  .code,
              0);
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    RenderOptions options;
    options.width = 40;
    options.height = 30;
    const json statistics = json::parse(content_of(folder.path() / "s.json"));
    EXPECT_EQ(std::stoull(statistics.at("image").at("hash").get<std::string>(), nullptr, 16),
              hash(render(bench, options).image));
}

TEST(Render, interrupted_it_stops_soon_and_leaves_nothing) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "b.png") << "old";
    TerminalProgram program({"render", "glass_bowl", "-o", "b.png", "--size", "4000x4000", "--threads", "1"},
                            {folder.path()});
    program.shown_until("0 %");
    const auto start = std::chrono::steady_clock::now();
    program.type("\x03");
    EXPECT_EQ(program.code(), 130);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    EXPECT_THAT(program.rest(), HasSubstr("stopped; nothing was written"));
    EXPECT_EQ(folder.names(), std::vector<std::string>{"b.png"});
    EXPECT_EQ(content_of(folder.path() / "b.png"), "old");
}

TEST(Render, a_file_that_may_not_grow_is_a_failed_write) {
    const TemporaryFolder folder;
    const auto expect_failure = [&](const std::vector<std::string>& arguments, const std::string& file) {
        const Outcome outcome = run_program(arguments, {folder.path(), {}, 2048});
        EXPECT_EQ(outcome.code, 1) << file;
        EXPECT_THAT(outcome.err, HasSubstr("rayscope: can't write " + file + ": "));
        EXPECT_THAT(outcome.err, HasSubstr("File too large"));
        EXPECT_THAT(folder.names(), IsEmpty());
    };
    for (const char* file : {"a.png", "a.pfm", "a.exr"})
        expect_failure({"render", "glass_bowl", "-o", file, "--size", "200x150"}, file);
    expect_failure({"trace", "glass_bowl", "-o", "a.json"}, "a.json");
}

TEST(TraceCommand, writes_the_trace_of_the_library) {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_program({"trace", "glass_bowl", "--pixel", "200,200", "-o", "r.json"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "r.json\n");
    Trace trace = trace_from_json(json::parse(content_of(folder.path() / "r.json")));
    EXPECT_THAT(trace.source.scene, EndsWith("glass_bowl.toml"));
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/glass_bowl.toml");
    Trace expected = trace_pixel(bench, 200, 200);
    trace.source.scene = expected.source.scene;
    EXPECT_EQ(to_json(trace), to_json(expected));
}

TEST(TraceCommand, every_shipped_scene_survives_the_round_trip) {
    const TemporaryFolder folder;
    for (const char* scene : {"glass_bowl", "cylinder_with_holes", "two_spheres", "mirror_room", "prism",
                              "bubble", "lens", "torus_chain"}) {
        ASSERT_EQ(run_program({"trace", scene, "-o", "r.json"}, {folder.path()}).code, 0) << scene;
        const std::string text = content_of(folder.path() / "r.json");
        EXPECT_EQ(to_json(trace_from_json(json::parse(text))).dump(1) + "\n", text) << scene;
    }
}

} // namespace
} // namespace rayscope::test
