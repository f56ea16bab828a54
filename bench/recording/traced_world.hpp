#pragma once
// Traces a small world with whatever tracer the headers hold: compiled once with them as they are, once stripped.

namespace rayscope {

/// The colours of a 64 × 64 image of mirroring balls and a bowl, added up.
[[nodiscard]] double trace_world();

} // namespace rayscope
