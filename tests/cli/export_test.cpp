// rayscope export: a file for POV-Ray, whole or not at all.

#include "core/rayscope.hpp"
#include "tests/cli/program.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(ExportCommand, writes_the_file_of_the_library) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program({"export", "two_spheres", "-o", "s.pov"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.out, "s.pov\n");
    EXPECT_THAT(outcome.err, IsEmpty());
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/02_csg/two_spheres.toml");
    EXPECT_EQ(content_of(folder.path() / "s.pov"), to_povray(bench.scene, bench.world).text);
}

TEST(ExportCommand, says_what_the_other_program_does_in_another_way) {
    const TemporaryFolder folder;
    const Outcome outcome = run_program({"export", "glass_bowl", "-o", "s.pov"}, {folder.path()});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err,
              "warning: in POV-Ray: total reflection mirrors all light, not reflection + transmission "
              "(glass)\n");
}

TEST(ExportCommand, what_is_wrong_writes_nothing) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "bad.toml") << "[generics.a]\nshape = \"sfere\"\n";
    const auto expect_error = [&](const std::vector<std::string>& arguments, int code,
                                  const std::string& message) {
        const Outcome outcome = run_program(arguments, {folder.path(), {}, 2048});
        EXPECT_EQ(outcome.code, code) << message;
        EXPECT_THAT(outcome.err, HasSubstr(message));
        EXPECT_EQ(folder.names(), std::vector<std::string>{"bad.toml"});
    };
    expect_error({"export", "-o", "s.pov"}, 2, "export needs a scene: rayscope export SCENE -o scene.pov");
    expect_error({"export", "lens"}, 2, "export needs to know where to write: -o scene.pov");
    expect_error({"export", "lens", "-o", "s.png"}, 2,
                 "-o: unknown extension '.png' in 's.png', expected .pov");
    expect_error({"export", "lens", "-o", "no/s.pov"}, 2, "-o: ");
    expect_error({"export", "lenz", "-o", "s.pov"}, 2, "did you mean 'lens'?");
    expect_error({"export", "bad.toml", "-o", "s.pov"}, 2, "bad.toml:2:");
    expect_error({"export", "mirror_room", "-o", "s.pov"}, 1, "can't write s.pov"); // longer than it may get
}

} // namespace
} // namespace rayscope::test
