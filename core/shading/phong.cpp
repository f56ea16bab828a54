#include "core/shading/phong.hpp"

#include <array>
#include <cstdint>
#include <numbers>

namespace rayscope {
namespace {

// log₂ of the mantissa, turned to lie about 1, by the series of artanh, up to s²¹: |s| < 0.172.
double binary_logarithm(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);
    if (m < std::numbers::sqrt2 / 2) {
        m *= 2;
        --exponent;
    }
    const double s = (m - 1) / (m + 1), squared = s * s;
    double sum = 1.0 / 21;
    for (int n = 19; n > 0; n -= 2) sum = fma(sum, squared, 1.0 / n);
    return fma(2 * std::numbers::log2e * s, sum, double(exponent));
}

// 1 / n!
constexpr std::array<double, 15> inverse_factorials = [] {
    std::array<double, 15> result{1};
    for (std::size_t n = 1; n < result.size(); ++n) result[n] = result[n - 1] / double(n);
    return result;
}();

// 2^y for y ≤ 0: Taylor's series for what is left beside the nearest whole number.
double binary_power(double y) {
    const double whole = std::floor(y + 0.5), r = (y - whole) * std::numbers::ln2;
    double sum = inverse_factorials.back();
    for (std::size_t n = inverse_factorials.size() - 1; n-- > 0;) sum = fma(sum, r, inverse_factorials[n]);
    return std::ldexp(sum, int(whole));
}

double fractional_power(double x, double n) { return x > 0 ? binary_power(n * binary_logarithm(x)) : 0; }

} // namespace

double phong_power(double x, double n) {
    constexpr double most = 0x1p63; // to such a power 1 stays 1, and nothing else leaves a trace
    if (n >= most) return x < 1 ? 0 : 1;
    auto whole = std::uint64_t(n);
    const double fraction = n - double(whole);
    double result = 1;
    for (double square = x; whole > 0; square *= square) {
        if (square == 0) return 0; // the leading digit of n is still to come
        if ((whole & 1U) != 0) result *= square;
        whole >>= 1U;
    }
    return fraction > 0 ? result * fractional_power(x, fraction) : result;
}

} // namespace rayscope
