#pragma once
// The chapters as text: which pages there are, and the programs that they show.

#include "tests/support/shell.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::test {

inline const std::filesystem::path chapters_root = RAYSCOPE_SOURCE_DIR;

/// The lessons' pages and what stands beside them, from the top level: "chapters/02_csg/README.md".
[[nodiscard]] std::vector<std::string> lesson_pages();

[[nodiscard]] std::string page_text(const std::string& page);
[[nodiscard]] std::vector<std::string> lines_of_text(const std::string& text);

/// `arguments` as they stand after ./rayscope in a page, read by a shell. `lesson NAME` runs that lesson.
/// @param folder in which it runs
[[nodiscard]] Printed printed_by(const std::string& arguments,
                                 const std::filesystem::path& folder = chapters_root);

/// A file that stands beside the program: "rayscope-view".
[[nodiscard]] std::filesystem::path built_program(const std::string& name);

} // namespace rayscope::test
