#pragma once
// One number for each pixel.

#include <filesystem>
#include <vector>

namespace rayscope {

/// width × height numbers, row by row from the top left.
struct Map {
    int width = 0, height = 0;
    std::vector<float> values;

    Map() = default;
    Map(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h)) {}
    [[nodiscard]] float& at(int x, int y) {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    [[nodiscard]] float at(int x, int y) const {
        return values[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
};

/// A .pfm of one channel ("Pf", little-endian), complete or not at all. Throws std::runtime_error that names the file.
void write_map(const Map& map, const std::filesystem::path& path);

/// Throws std::runtime_error that names the file and what was expected.
[[nodiscard]] Map read_map(const std::filesystem::path& path);

} // namespace rayscope
