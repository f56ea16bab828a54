#pragma once
// Where a walk stands, as JSON: the same for every view that writes it.

#include "core/walk/walk.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rayscope {

/// Members ray, event, moment, moments, kind, depth, weight, what (the event's name) and data (the event as the trace's
/// JSON has it).
[[nodiscard]] nlohmann::json state_json(const Walk& walk);

/// A value as JSON: nothing is null, a vector a list of three.
[[nodiscard]] nlohmann::json value_json(const Value& value);

} // namespace rayscope
