#pragma once
// What `rayscope explain --cost` leaves in a folder.

#include "core/rayscope.hpp"

namespace rayscope::cli {

/// Into a folder that is there: one picture for each effect, with it, without it, and the difference. effects.json holds
/// the numbers, effects.png is their chart, where this build can draw. Names the files on stdout.
void write_effects(const std::string& scene, const EffectCosts& costs, const std::filesystem::path& folder);

} // namespace rayscope::cli
