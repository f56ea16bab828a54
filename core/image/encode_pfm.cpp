#include "core/image/encoders.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace rayscope {

void encode_pfm(const Image& image, const std::filesystem::path& path) {
    static_assert(std::endian::native == std::endian::little && sizeof(float) == 4);
    std::ofstream out(path, std::ios::binary);
    // The sign of the scale tells the byte order: negative is little-endian.
    out << fmt::format("PF\n{} {}\n-1.0\n", image.width, image.height);
    const std::size_t row = 3 * std::size_t(image.width);
    for (int y = image.height - 1; y >= 0; --y)
        out.write(reinterpret_cast<const char*>(&image.rgb[std::size_t(y) * row]),
                  std::streamsize(row * sizeof(float)));
    out.close();
    if (!out) throw std::runtime_error(std::strerror(errno));
}

} // namespace rayscope
