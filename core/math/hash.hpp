#pragma once
// A hash that is the same everywhere.

#include <cstddef>
#include <cstdint>

namespace rayscope {

/// FNV-1a, 64 bits.
class Fnv1a {
public:
    Fnv1a& add(const void* data, std::size_t size) {
        const auto* bytes = static_cast<const unsigned char*>(data);
        for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * 0x100000001b3U;
        return *this;
    }
    [[nodiscard]] std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325U;
};

} // namespace rayscope
