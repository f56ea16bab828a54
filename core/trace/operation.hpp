#pragma once
// What a node of a compound does.

#include <cstdint>

namespace rayscope {

enum class Operation : std::uint8_t { leaf, set_union, intersection, difference, complement };

} // namespace rayscope
