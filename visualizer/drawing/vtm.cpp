#include "visualizer/drawing/vtm.hpp"

#include "visualizer/drawing/scene_objects.hpp"
#include "visualizer/drawing/surfaces.hpp"
#include "visualizer/drawing/trace_geometry.hpp"

#include <vtkAppendPolyData.h>
#include <vtkCompositeDataSet.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkXMLMultiBlockDataWriter.h>

#include <fmt/core.h>

namespace rayscope::drawing {
namespace {

namespace fs = std::filesystem;

void put(vtkMultiBlockDataSet* blocks, const std::string& name, vtkDataObject* block) {
    const unsigned index = blocks->GetNumberOfBlocks();
    blocks->SetBlock(index, block);
    blocks->GetMetaData(index)->Set(vtkCompositeDataSet::NAME(), name.c_str());
}

vtkSmartPointer<vtkPolyData> joined(const Pieces& pieces) {
    vtkNew<vtkAppendPolyData> all;
    for (const auto& piece : pieces) all->AddInputData(piece);
    all->Update();
    return all->GetOutput();
}

/// A folder that a person keeps other things in is not ours to replace.
void check_replaceable(const fs::path& folder) {
    if (!fs::exists(folder)) return;
    const std::string prefix = folder.filename().string() + "_";
    const auto refuse = [&] {
        throw std::runtime_error(folder.string() +
                                 ": is in the way and holds other things than a .vtm's blocks");
    };
    if (!fs::is_directory(folder)) refuse();
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        if (!entry.is_directory() && (!name.starts_with(prefix) || entry.path().extension() != ".vtp"))
            refuse();
    }
}

/// A new empty folder beside a file.
class Workshop : public TemporaryFolder {
public:
    explicit Workshop(const fs::path& file) try
        : TemporaryFolder(file.parent_path() / fmt::format(".{}.XXXXXX", file.filename().string())) {
    } catch (const std::runtime_error&) {
        throw std::runtime_error(file.string() + ": can't be written: its folder is missing or closed");
    }
};

} // namespace

vtkSmartPointer<vtkMultiBlockDataSet> multiblock(const Workbench& bench, const Trace& trace) {
    const std::vector<Id> drawn = drawn_objects(trace, bench.scene);
    const Region region = region_of(trace, bench, drawn);
    auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    put(blocks, "rays", rays_polydata(trace, region.open_length()));
    put(blocks, "hits", hits_polydata(trace));
    put(blocks, "inside_intervals", spans_polydata(trace, region.open_length()));
    if (const auto places = places_polydata(trace); places->GetNumberOfCells() > 0)
        put(blocks, "places", places);
    vtkNew<vtkMultiBlockDataSet> surfaces;
    for (const Surface& surface : surfaces_near(bench, trace, drawn, region).shown)
        if (!surface.pieces.empty()) put(surfaces, surface.name, joined(surface.pieces));
    put(blocks, "surfaces", surfaces);
    vtkNew<vtkIntArray> schema;
    schema->SetName("trace_schema");
    schema->InsertNextValue(trace_schema_version);
    blocks->GetFieldData()->AddArray(schema);
    return blocks;
}

void write_vtm(const Workbench& bench, const Trace& trace, const fs::path& path) {
    if (path.extension() != ".vtm" || path.stem().empty())
        throw InputError(path.string(), {}, "the name of a file for ParaView must end in .vtm");
    if (trace.rays.empty()) throw InputError(trace.source.scene, {}, "the trace has no rays");
    check_writable(path);
    const fs::path folder = path.parent_path() / path.stem();
    check_replaceable(folder);
    const Workshop workshop(path);
    const fs::path made = workshop.path() / path.filename();
    vtkNew<vtkXMLMultiBlockDataWriter> writer;
    writer->SetInputData(multiblock(bench, trace));
    writer->SetFileName(made.c_str());
    if (writer->Write() == 0 || writer->GetErrorCode() != 0)
        throw std::runtime_error(path.string() + ": can't be written");
    // Two names can't change at once. The .vtm goes first and comes last: it never points at blocks of another trace.
    fs::remove(path);
    if (fs::exists(folder)) fs::rename(folder, workshop.path() / "old blocks");
    fs::rename(workshop.path() / path.stem(), folder);
    fs::rename(made, path);
}

} // namespace rayscope::drawing
