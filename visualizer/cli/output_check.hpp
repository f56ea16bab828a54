#pragma once
// Whether a result can be written, asked before the work is done.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope::cli {

/// Throws UsageError unless the file's extension is one of these and its folder can be written.
void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string_view>& extensions);

/// Makes the folder if need be. Throws UsageError that names it if it can't be, or if the file can't be written there.
void prepare_folder(const std::filesystem::path& folder, std::string_view file);

} // namespace rayscope::cli
