#pragma once
// The three file formats, each written to a path that is its own (see write_image).

#include "core/image/image.hpp"

namespace rayscope {

/// 8-bit sRGB. Throws std::runtime_error that says why.
void encode_png(const Image& image, const std::filesystem::path& path);

/// Portable float map, colour, little-endian: rows from the bottom up. Throws std::runtime_error.
void encode_pfm(const Image& image, const std::filesystem::path& path);

/// OpenEXR with float channels R, G, B. Throws std::runtime_error.
void encode_exr(const Image& image, const std::filesystem::path& path);

} // namespace rayscope
