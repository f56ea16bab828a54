#include "visualizer/drawing/averaged.hpp"

namespace rayscope::drawing {

Raster averaged(const PictureSize& size, vtkUnsignedCharArray* pixels, int oversampling) {
    Raster raster{size.width, size.height,
                  std::vector<std::uint8_t>(std::size_t(size.width) * std::size_t(size.height) * 3)};
    const std::uint8_t* source = pixels->GetPointer(0);
    const std::size_t row = std::size_t(size.width * oversampling) * 3;
    std::size_t out = 0;
    for (int y = size.height - 1; y >= 0; --y) // VTK's rows start at the bottom
        for (int x = 0; x < size.width; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int j = 0; j < oversampling; ++j)
                    for (int i = 0; i < oversampling; ++i)
                        sum += source[std::size_t(y * oversampling + j) * row +
                                      std::size_t(x * oversampling + i) * 3 + channel];
                const int samples = oversampling * oversampling;
                raster.bytes[out++] = std::uint8_t((sum + samples / 2) / samples);
            }
    return raster;
}

} // namespace rayscope::drawing
