#pragma once
// What a scene's reader found odd, but not wrong.

#include "core/rayscope.hpp"

#include <string>
#include <vector>

namespace rayscope::cli {

/// To stderr; the first of them only, if there are many.
void print_warnings(const std::vector<std::string>& warnings);
void print_warnings(const Scene& scene);

} // namespace rayscope::cli
