#include "visualizer/drawing/write_png.hpp"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace rayscope::drawing {
namespace {

vtkSmartPointer<vtkImageData> image_of(const Raster& raster) {
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(raster.width, raster.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    const std::size_t row = std::size_t(raster.width) * 3;
    for (int y = 0; y < raster.height; ++y) // VTK's images start at the lower left
        std::copy_n(raster.bytes.data() + std::size_t(raster.height - 1 - y) * row, row,
                    static_cast<std::uint8_t*>(image->GetScalarPointer(0, y, 0)));
    return image;
}

} // namespace

void write_png(const Raster& raster, const std::filesystem::path& path) {
    AtomicFile file(path);
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image_of(raster));
    writer->SetFileName(file.temporary().c_str());
    writer->Write();
    if (writer->GetErrorCode() != 0) throw std::runtime_error(path.string() + ": can't be written");
    file.commit();
}

std::vector<std::uint8_t> png_bytes(const Raster& raster) {
    vtkNew<vtkPNGWriter> writer;
    writer->WriteToMemoryOn();
    writer->SetCompressionLevel(9);
    writer->SetInputData(image_of(raster));
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
}

} // namespace rayscope::drawing
