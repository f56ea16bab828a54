#pragma once
// A trace for ParaView.

#include "core/rayscope.hpp"

#include <vtkMultiBlockDataSet.h>
#include <vtkSmartPointer.h>

namespace rayscope::drawing {

/// Blocks rays, hits and inside_intervals (see trace_geometry for their arrays) and surfaces, which has one block for
/// each object near the rays, by name. Field data: trace_schema.
[[nodiscard]] vtkSmartPointer<vtkMultiBlockDataSet> multiblock(const Workbench& bench, const Trace& trace);

/// Writes NAME.vtm and the folder NAME beside it, which holds the blocks. The folder replaces an older one only if
/// that holds nothing but blocks; throws std::runtime_error otherwise, and where a file can't be written.
void write_vtm(const Workbench& bench, const Trace& trace, const std::filesystem::path& path);

} // namespace rayscope::drawing
