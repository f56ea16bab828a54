#pragma once
// Case files: one JSON object a line.

#include "core/cases/exact_cases.hpp"

#include <filesystem>

namespace rayscope {

/// Throw InputError where a file can't be read, with the line that is wrong.
[[nodiscard]] std::vector<LineCase> read_line_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<RefractionCase> read_refraction_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<TriangleCase> read_triangle_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<CavityCase> read_cavity_cases(const std::filesystem::path& path);
[[nodiscard]] std::vector<GridCase> read_grid_cases(const std::filesystem::path& path);

} // namespace rayscope
