// The file for ParaView can be read back, whole.

#include "visualizer/drawing/vtm.hpp"

#include "tests/drawing/bowl.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/drawing/clip_compound.hpp"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLMultiBlockDataReader.h>

namespace rayscope::test {
namespace {

namespace fs = std::filesystem;

vtkSmartPointer<vtkMultiBlockDataSet> read(const fs::path& path) {
    vtkNew<vtkXMLMultiBlockDataReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
}

vtkDataObject* block(vtkMultiBlockDataSet* blocks, const std::string& name) {
    for (unsigned i = 0; i < blocks->GetNumberOfBlocks(); ++i)
        if (blocks->GetMetaData(i)->Get(vtkCompositeDataSet::NAME()) == name) return blocks->GetBlock(i);
    return nullptr;
}

TEST(Vtm, has_all_blocks_and_arrays_with_the_traces_own_points) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "bowl.vtm";
    const Trace trace = bowl_trace();
    drawing::write_vtm(bowl(), trace, path);
    const auto blocks = read(path);
    ASSERT_NE(blocks, nullptr);
    auto* rays = vtkPolyData::SafeDownCast(block(blocks, "rays"));
    auto* hits = vtkPolyData::SafeDownCast(block(blocks, "hits"));
    auto* inside = vtkPolyData::SafeDownCast(block(blocks, "inside_intervals"));
    auto* surfaces = vtkMultiBlockDataSet::SafeDownCast(block(blocks, "surfaces"));
    ASSERT_TRUE(rays != nullptr && hits != nullptr && inside != nullptr && surfaces != nullptr);
    for (const char* name : {"ray_id", "parent_id", "step", "depth", "kind", "kind_name", "object_name",
                             "t_hit", "weight", "direction", "open", "blocked"})
        EXPECT_TRUE(rays->GetCellData()->HasArray(name)) << name;
    for (const char* name : {"ray_id", "step", "object_name", "t_hit", "error_bound", "Normals"})
        EXPECT_TRUE(hits->GetPointData()->HasArray(name)) << name;
    for (const char* name : {"ray_id", "step", "object_id", "node_id", "node_name", "t_enter", "t_exit"})
        EXPECT_TRUE(inside->GetCellData()->HasArray(name)) << name;
    for (const char* name : {"bowl", "cherry"}) EXPECT_NE(block(surfaces, name), nullptr) << name;
    ASSERT_EQ(rays->GetNumberOfLines(), vtkIdType(trace.rays.size()));
    for (vtkIdType i = 0; i < rays->GetNumberOfLines(); ++i)
        EXPECT_EQ(drawing::point_of(rays, 2 * i), trace.rays[std::size_t(i)].start().origin);
}

TEST(Vtm, replaces_an_older_one_and_nothing_else) {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "out.vtm";
    drawing::write_vtm(bowl(), bowl_trace(), path);
    drawing::write_vtm(bowl(), bowl_trace(), path);
    EXPECT_NE(read(path), nullptr);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 2) << "only out.vtm and out stay";

    const fs::path thesis = folder.path() / "out" / "thesis.txt";
    write_text_file(thesis, "years of work");
    EXPECT_THROW(drawing::write_vtm(bowl(), bowl_trace(), path), std::runtime_error);
    EXPECT_TRUE(fs::exists(thesis));
    EXPECT_NE(read(path), nullptr) << "the old file is whole";
}

TEST(Vtm, leaves_nothing_where_it_cant_write) {
    const TemporaryFolder folder;
    EXPECT_THROW(drawing::write_vtm(bowl(), bowl_trace(), folder.path() / "no folder" / "a.vtm"),
                 std::runtime_error);
    EXPECT_THROW(drawing::write_vtm(bowl(), bowl_trace(), folder.path() / "a.txt"), InputError);
    EXPECT_TRUE(fs::is_empty(folder.path()));
}

} // namespace
} // namespace rayscope::test
