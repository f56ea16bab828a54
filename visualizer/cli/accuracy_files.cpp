#include "visualizer/cli/accuracy_files.hpp"

#include <fmt/format.h>

#include <cstdlib>

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

fs::path from_environment(const char* name) {
    const char* value = std::getenv(name);
    return value != nullptr ? fs::path(value) : fs::path();
}

} // namespace

fs::path cache_folder() {
    // The XDG base directory specification: a relative path is invalid, and ignored.
    if (const fs::path cache = from_environment("XDG_CACHE_HOME"); cache.is_absolute())
        return cache / "rayscope";
    if (const fs::path home = from_environment("HOME"); home.is_absolute())
        return home / ".cache" / "rayscope";
    return {};
}

std::string write_error_map(const fs::path& folder, const Configuration& configuration, const Map& map) {
    std::string name = "error-" + name_of(configuration) + ".pfm";
    std::erase(name, ',');
    std::replace(name.begin(), name.end(), ' ', '-');
    write_map(map, folder / name);
    return name;
}

fs::path write_report(const fs::path& folder, const AccuracyReport& report) {
    write_text_file(folder / "accuracy.csv", accuracy_csv(report));
    const fs::path file = folder / "accuracy.json";
    write_text_file(file, accuracy_json(report));
    return file;
}

} // namespace rayscope::cli
