#pragma once
// Who may include whom: the floors of the architecture as one table.

#include <optional>
#include <string>
#include <string_view>

namespace rayscope::test {

/// The rule that the file `includer` breaks by including `included`, or nothing.
///
/// @param includer path from the top level, "core/csg/sweep.cpp"
/// @param included what stands between the quotes or brackets, "core/math/vec.hpp" or "vtkActor.h"
[[nodiscard]] std::optional<std::string> broken_rule(std::string_view includer, std::string_view included);

} // namespace rayscope::test
