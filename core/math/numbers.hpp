#pragma once
// Numbers: with which scalar type, and by which formulas, a ray is followed.

#include "core/math/scalar.hpp"

#include <array>
#include <optional>
#include <string_view>

namespace rayscope {

enum class Method {
    stable,   ///< the formulas that keep their digits, with error bounds
    textbook, ///< the schoolbook's, to be compared
};

/// Numbers whose formulas are the schoolbook's. A bare scalar type stands for the stable ones, so nobody gets these
/// unasked: World<double> is stable, World<Textbook<double>> is not.
template <Scalar T> struct Textbook {};

namespace numbers {
template <typename N> struct Traits;
template <Scalar T> struct Traits<T> {
    using Scalar = T;
    static constexpr Method method = Method::stable;
};
template <Scalar T> struct Traits<Textbook<T>> {
    using Scalar = T;
    static constexpr Method method = Method::textbook;
};
} // namespace numbers

/// A scalar type × a method: what the core up to the tracer is a template over.
template <typename N>
concept Numbers = requires { typename numbers::Traits<N>::Scalar; };

template <Numbers N> using ScalarOf = typename numbers::Traits<N>::Scalar;
template <Numbers N> inline constexpr bool is_textbook = numbers::Traits<N>::method == Method::textbook;

/// The t at which a secondary ray begins. The schoolbook skips the surface that the ray leaves by a constant, right for
/// scenes of the usual size alone; the stable way names the surfaces that are left, and needs none.
template <Numbers N> inline constexpr ScalarOf<N> secondary_start = ScalarOf<N>(is_textbook<N> ? 1e-4 : 0.0);

enum class ScalarType { float32, float64, float80, float128 };

/// The same, chosen while the program runs.
struct NumbersChoice {
    ScalarType scalar = ScalarType::float64;
    Method method = Method::stable;

    friend bool operator==(const NumbersChoice&, const NumbersChoice&) = default;
};

/// Every choice, stable before textbook, narrow before wide.
inline constexpr std::array<NumbersChoice, 8> all_numbers{{
    {ScalarType::float32, Method::stable},
    {ScalarType::float32, Method::textbook},
    {ScalarType::float64, Method::stable},
    {ScalarType::float64, Method::textbook},
    {ScalarType::float80, Method::stable},
    {ScalarType::float80, Method::textbook},
    {ScalarType::float128, Method::stable},
    {ScalarType::float128, Method::textbook},
}};

/// Calls visit.operator()<N>() with the type that was chosen.
template <typename Visit> decltype(auto) with_numbers(NumbersChoice choice, const Visit& visit) {
    const auto with = [&]<Scalar T>() -> decltype(auto) {
        if (choice.method == Method::textbook) return visit.template operator()<Textbook<T>>();
        return visit.template operator()<T>();
    };
    switch (choice.scalar) {
    case ScalarType::float32: return with.template operator()<float>();
    case ScalarType::float80: return with.template operator()<long double>();
    case ScalarType::float128: return with.template operator()<Float128>();
    case ScalarType::float64: break;
    }
    return with.template operator()<double>();
}

/// "float", "double", "long double", "float128"
[[nodiscard]] std::string_view scalar_name(ScalarType scalar);
/// "stable", "textbook"
[[nodiscard]] std::string_view method_name(Method method);
/// As scalar_name and method_name write them; nothing for any other text.
[[nodiscard]] std::optional<ScalarType> scalar_named(std::string_view name);
[[nodiscard]] std::optional<Method> method_named(std::string_view name);

/// How finely a type's numbers are made; in doubles, the types that reach farther as far as doubles go.
struct Precision {
    double epsilon = rayscope::epsilon<double>;
    double least = std::numeric_limits<double>::min(); ///< below it digits run out
};
[[nodiscard]] Precision precision_of(ScalarType scalar);

} // namespace rayscope
