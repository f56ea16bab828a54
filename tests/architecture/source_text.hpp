#pragma once
// The source files of the project, and their text without what the compiler skips.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::test {

inline const std::filesystem::path source_tree = RAYSCOPE_SOURCE_DIR;

/// All .hpp and .cpp files under a top-level folder, sorted; none if there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> sources_under(const std::filesystem::path& folder);

/// Its lines. Throws std::runtime_error where the file can't be read.
[[nodiscard]] std::vector<std::string> lines_of(const std::filesystem::path& file);

/// The same lines with comments blanked out, of the same lengths.
[[nodiscard]] std::vector<std::string> without_comments(std::vector<std::string> lines);

/// A line (without comments) with the inside of its string and character literals blanked out.
[[nodiscard]] std::string without_literals(std::string line);

} // namespace rayscope::test
