#include "core/math/numbers.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr std::array<std::string_view, 4> scalars{"float", "double", "long double", "float128"};
constexpr std::array<std::string_view, 2> methods{"stable", "textbook"};

template <typename Choice, std::size_t Count>
std::optional<Choice> named(const std::array<std::string_view, Count>& names, std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return Choice(found - names.begin());
}

} // namespace

std::string_view scalar_name(ScalarType scalar) { return scalars[std::size_t(scalar)]; }
std::string_view method_name(Method method) { return methods[std::size_t(method)]; }
std::optional<ScalarType> scalar_named(std::string_view name) { return named<ScalarType>(scalars, name); }
std::optional<Method> method_named(std::string_view name) { return named<Method>(methods, name); }

Precision precision_of(ScalarType scalar) {
    return with_numbers({scalar, Method::stable}, []<Numbers N>() -> Precision {
        Precision precision{double(epsilon<ScalarOf<N>>)};
        if constexpr (std::same_as<N, float>) precision.least = double(std::numeric_limits<float>::min());
        return precision;
    });
}

} // namespace rayscope
