#include "core/image/map.hpp"

#include "core/files/atomic_file.hpp"

#include <fmt/format.h>

#include <bit>
#include <fstream>
#include <stdexcept>

namespace rayscope {

void write_map(const Map& map, const std::filesystem::path& path) {
    static_assert(std::endian::native == std::endian::little && sizeof(float) == 4);
    // A negative scale: little-endian. Rows from the bottom up.
    std::string text = fmt::format("Pf\n{} {}\n-1.0\n", map.width, map.height);
    for (int y = map.height - 1; y >= 0; --y)
        text.append(reinterpret_cast<const char*>(&map.values[std::size_t(y) * std::size_t(map.width)]),
                    std::size_t(map.width) * sizeof(float));
    write_text_file(path, text);
}

Map read_map(const std::filesystem::path& path) {
    constexpr int largest_side = 32768;
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    double scale = 0;
    int width = 0, height = 0;
    file >> magic >> width >> height >> scale;
    if (!file || magic != "Pf" || width < 1 || height < 1 || width > largest_side || height > largest_side ||
        !(scale < 0))
        throw std::runtime_error(path.string() + ": expected a little-endian .pfm of one channel (Pf)");
    file.get();
    std::error_code error;
    const std::size_t pixels = std::size_t(width) * std::size_t(height);
    if (std::filesystem::file_size(path, error) - std::uintmax_t(file.tellg()) != pixels * sizeof(float))
        throw std::runtime_error(path.string() + ": expected " + std::to_string(pixels) +
                                 " numbers of 4 bytes after the header");
    Map map(width, height);
    for (int y = height - 1; y >= 0; --y)
        file.read(reinterpret_cast<char*>(&map.values[std::size_t(y) * std::size_t(width)]),
                  std::streamsize(std::size_t(width) * sizeof(float)));
    return map;
}

} // namespace rayscope
