#include "core/generics/generic.hpp"

#include <array>

namespace rayscope {
namespace {

template <std::size_t... I> constexpr auto names(std::index_sequence<I...>) {
    return std::array{std::variant_alternative_t<I, Generic<double>>::name...};
}

} // namespace

const char* generic_name(std::size_t kind) {
    return names(std::make_index_sequence<generic_kinds>{}).at(kind);
}

} // namespace rayscope
