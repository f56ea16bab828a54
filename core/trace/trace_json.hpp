#pragma once
// A Trace as JSON: the schema is documented in chapters/reference/trace-format.md.

#include "core/trace/trace.hpp"

#include <nlohmann/json_fwd.hpp>

namespace rayscope {

/// Version of the schema that to_json writes; from_json accepts this one only.
inline constexpr int trace_schema_version = 4;
/// The member "format" of every trace.
inline constexpr const char* trace_format_name = "rayscope-trace";

/// Every number survives the round trip exactly; infinities and NaN are the strings "inf", "-inf", "nan".
[[nodiscard]] nlohmann::json to_json(const Trace& trace);

/// One event as it stands in the list of its ray.
[[nodiscard]] nlohmann::json to_json(const Event& event);
/// A number as a trace has it.
[[nodiscard]] nlohmann::json number_json(double number);

/// Throws std::runtime_error that says which member is missing or wrong, and what was expected.
[[nodiscard]] Trace trace_from_json(const nlohmann::json& json);

} // namespace rayscope
