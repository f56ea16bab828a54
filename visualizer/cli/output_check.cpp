#include "visualizer/cli/output_check.hpp"

#include "core/rayscope.hpp"
#include "visualizer/cli/failure.hpp"

#include <algorithm>

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

void check_writable_for(const std::string& option, const fs::path& file) {
    try {
        check_writable(file);
    } catch (const std::runtime_error& error) {
        throw UsageError(option + ": " + error.what());
    }
}

} // namespace

void check_output(const std::string& option, const std::string& file,
                  const std::vector<std::string_view>& extensions) {
    const std::string extension = fs::path(file).extension().string();
    if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
        throw UsageError(option + ": " +
                         (extension.empty() ? "no extension" : "unknown extension " + in_quotes(extension)) +
                         " in " + in_quotes(file) + ", expected " + one_of(extensions) +
                         did_you_mean(extension, extensions));
    check_writable_for(option, file);
}

void prepare_folder(const fs::path& folder, std::string_view file) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder))
        throw UsageError("-o: expected a folder, or a name for a new one, found '" + folder.string() +
                         "': " + (error ? error.message() : "not a folder"));
    check_writable_for("-o", folder / file);
}

} // namespace rayscope::cli
