#pragma once
// A picture in linear light, and the files that hold one.

#include "core/math/vec.hpp"

#include <filesystem>
#include <vector>

namespace rayscope {

/// width × height pixels, linear RGB in float, row by row from the top left.
struct Image {
    int width = 0, height = 0;
    std::vector<float> rgb; ///< 3 · width · height

    Image() = default;
    Image(int w, int h) : width(w), height(h), rgb(3 * std::size_t(w) * std::size_t(h)) {}
    void set(int x, int y, const Colour& colour) {
        float* pixel = &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
        for (int i = 0; i < 3; ++i) pixel[i] = float(colour[i]);
    }
    [[nodiscard]] Colour at(int x, int y) const {
        const float* pixel = &rgb[3 * (std::size_t(y) * std::size_t(width) + std::size_t(x))];
        return {double(pixel[0]), double(pixel[1]), double(pixel[2])};
    }
};

/// True for the extensions that write_image knows: .png .pfm .exr.
[[nodiscard]] bool is_image_path(const std::filesystem::path& path);

/// Writes by extension: .png clamped to [0,1] and sRGB-encoded in 8 bits; .pfm and .exr as they are, 32-bit float.
/// The file appears complete or not at all. Throws std::runtime_error that names the file.
void write_image(const Image& image, const std::filesystem::path& path);

/// FNV-1a over the size and the bytes of rgb: equal images, equal hash.
[[nodiscard]] std::uint64_t hash(const Image& image);

} // namespace rayscope
