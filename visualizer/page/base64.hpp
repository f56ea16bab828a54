#pragma once
// Bytes as text (RFC 4648).

#include <cstdint>
#include <span>
#include <string>

namespace rayscope::page {

[[nodiscard]] std::string base64(std::span<const std::uint8_t> bytes);

/// Little-endian, as every browser's typed arrays are.
[[nodiscard]] std::string base64(std::span<const std::uint16_t> words);

} // namespace rayscope::page
