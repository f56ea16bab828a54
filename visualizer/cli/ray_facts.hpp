#pragma once
// What several texts ask of a trace.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::cli {

[[nodiscard]] std::string object_name(const Trace& trace, Id object);
[[nodiscard]] std::string generic_name_of(const Trace& trace, Id generic);
[[nodiscard]] std::string medium_name(const Trace& trace, Id medium);
[[nodiscard]] std::string light_name(const Trace& trace, Id light);

/// "ray 3"
[[nodiscard]] std::string ray_name(int ray);

/// What a reflected or refracted ray's colour is multiplied by before its parent adds it.
[[nodiscard]] Colour coefficient_of(const Trace& trace, int ray);

/// The shadow ray of `ray` that asks for this light, or none.
[[nodiscard]] int shadow_ray_to(const Trace& trace, int ray, Id light);

} // namespace rayscope::cli
