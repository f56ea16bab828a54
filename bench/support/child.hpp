#pragma once
// Other programs, run to their end.

#include <filesystem>
#include <string>
#include <vector>

namespace rayscope::bench {

/// Where this program lies: the others that are built lie beside it.
[[nodiscard]] std::filesystem::path program_folder();

/// Its exit code; 127 if it can't be run.
[[nodiscard]] int run_child(const std::vector<std::string>& words);
/// What it writes to stdout and stderr.
[[nodiscard]] std::string output_of(const std::vector<std::string>& words);

} // namespace rayscope::bench
