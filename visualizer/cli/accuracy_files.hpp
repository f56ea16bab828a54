#pragma once
// Where `rayscope accuracy` keeps what it made.

#include "core/rayscope.hpp"

namespace rayscope::cli {

/// $XDG_CACHE_HOME/rayscope, else ~/.cache/rayscope; empty where neither is known.
[[nodiscard]] std::filesystem::path cache_folder();

/// Writes the error map of a configuration and returns its name: error-….pfm, one channel, CIEDE2000 per pixel.
[[nodiscard]] std::string write_error_map(const std::filesystem::path& folder,
                                          const Configuration& configuration, const Map& map);

/// accuracy.json and accuracy.csv; returns the path of the first.
std::filesystem::path write_report(const std::filesystem::path& folder, const AccuracyReport& report);

} // namespace rayscope::cli
