#pragma once
// The header of a PLY file (Turk 1994): what its body holds.

#include "core/scene/input_error.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

[[nodiscard]] std::size_t size_of(PlyType type);

struct PlyProperty {
    std::string_view name;
    PlyType type = PlyType::float32;
    std::optional<PlyType> count; ///< a list's, which stands before it
};

struct PlyElement {
    std::string_view name;
    std::size_t count = 0;
    std::vector<PlyProperty> properties;

    [[nodiscard]] std::optional<std::size_t> find(std::string_view property) const;
};

enum class PlyFormat : std::uint8_t { ascii, little_endian, big_endian };

/// Views of the text.
struct PlyHeader {
    PlyFormat format = PlyFormat::ascii;
    std::vector<PlyElement> elements;
    std::size_t body = 0; ///< where it begins
    int body_line = 1;
};

/// Throws InputError, also where the file is too short for the elements that it promises.
[[nodiscard]] PlyHeader read_ply_header(std::string_view text, const std::string& file);

} // namespace rayscope
