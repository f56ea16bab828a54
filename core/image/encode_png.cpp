#include "core/image/encoders.hpp"
#include "core/image/srgb.hpp"

#include <png.h>

#include <algorithm>
#include <stdexcept>

namespace rayscope {

void encode_png(const Image& image, const std::filesystem::path& path) {
    std::vector<png_byte> bytes(image.rgb.size());
    std::transform(image.rgb.begin(), image.rgb.end(), bytes.begin(), srgb_byte);
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    header.width = png_uint_32(image.width);
    header.height = png_uint_32(image.height);
    header.format = PNG_FORMAT_RGB; // 8-bit RGB means sRGB to libpng, and the file says so
    if (png_image_write_to_file(&header, path.c_str(), 0, bytes.data(), 0, nullptr) == 0)
        throw std::runtime_error(header.message);
}

} // namespace rayscope
