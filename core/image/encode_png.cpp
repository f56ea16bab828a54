#include "core/image/encoders.hpp"
#include "core/image/srgb.hpp"

#include <png.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
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
    std::FILE* const file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) throw std::runtime_error(std::strerror(errno));
    errno = 0;
    const bool written = png_image_write_to_stdio(&header, file, 0, bytes.data(), 0, nullptr) != 0;
    int error = errno; // libpng's own words for it are "Write Error"
    const bool closed = std::fclose(file) == 0;
    if (written && !closed) error = errno;
    if (!written || !closed) throw std::runtime_error(error != 0 ? std::strerror(error) : header.message);
}

} // namespace rayscope
