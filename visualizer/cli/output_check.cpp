#include "visualizer/cli/output_check.hpp"

#include "core/rayscope.hpp"
#include "visualizer/cli/failure.hpp"

#include <algorithm>

namespace rayscope::cli {

void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string_view>& extensions) {
    const std::string extension = std::filesystem::path(file).extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
        throw UsageError(option + ": " +
                         (extension.empty() ? "no extension" : "unknown extension " + in_quotes(extension)) +
                         " in " + in_quotes(file) + ", expected " + one_of(extensions) +
                         did_you_mean(extension, extensions));
    try {
        check_writable(file);
    } catch (const std::runtime_error& error) {
        throw UsageError(option + ": " + error.what());
    }
}

} // namespace rayscope::cli
