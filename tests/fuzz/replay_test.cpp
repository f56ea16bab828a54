// Every input that a fuzzer found interesting, once more: a scene or an InputError, nothing else.

#include "core/scene/read_nff.hpp"
#include "core/scene/read_toml.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace rayscope {
namespace {

template <typename Read> int replay(const char* reader, const Read& read) {
    std::vector<std::filesystem::path> files;
    const std::filesystem::path folder =
        std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "tests/fuzz/corpus" / reader;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    int scenes = 0;
    for (const auto& file : files) {
        SCOPED_TRACE(file.string());
        std::ifstream stream(file, std::ios::binary);
        const std::string text{std::istreambuf_iterator<char>(stream), {}};
        try {
            (void)read(text, file.filename().string());
            ++scenes;
        } catch (const InputError& error) {
            EXPECT_FALSE(error.message.empty());
            EXPECT_GE(error.place.line, 1);
            EXPECT_GE(error.place.column, 1);
        }
    }
    EXPECT_GE(files.size(), 5U);
    return scenes;
}

TEST(Fuzz, TomlCorpus) { EXPECT_GE(replay("toml", parse_toml), 1) << "everything.toml should be a scene"; }
TEST(Fuzz, NffCorpus) { EXPECT_GE(replay("nff", parse_nff), 1) << "everything.nff should be a scene"; }

} // namespace
} // namespace rayscope
