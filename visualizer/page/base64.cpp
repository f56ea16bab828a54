#include "visualizer/page/base64.hpp"

#include <vector>

namespace rayscope::page {

std::string base64(std::span<const std::uint8_t> bytes) {
    static constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byte = [&](std::size_t k) { return i + k < bytes.size() ? unsigned(bytes[i + k]) : 0U; };
        const unsigned group = byte(0) << 16U | byte(1) << 8U | byte(2);
        for (unsigned k = 0; k < 4; ++k)
            text += i + k <= bytes.size() ? letters[group >> (18 - 6 * k) & 63U] : '=';
    }
    return text;
}

std::string base64(std::span<const std::uint16_t> words) {
    std::vector<std::uint8_t> bytes;
    for (const std::uint16_t word : words) {
        bytes.push_back(std::uint8_t(word & 255U));
        bytes.push_back(std::uint8_t(word >> 8U));
    }
    return base64(std::span<const std::uint8_t>(bytes));
}

} // namespace rayscope::page
