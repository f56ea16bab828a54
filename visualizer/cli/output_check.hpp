#pragma once
// Whether a result can be written, asked before the work is done.

#include <string>
#include <string_view>
#include <vector>

namespace rayscope::cli {

/// Throws UsageError unless the file's extension is one of these and its folder can be written.
void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string_view>& extensions);

} // namespace rayscope::cli
