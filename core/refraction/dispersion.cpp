#include "core/refraction/dispersion.hpp"

#include <cmath>
#include <limits>

namespace rayscope {
namespace {

double squared_micrometres(double wavelength) { return (wavelength / 1000) * (wavelength / 1000); }

} // namespace

// n = A + B / λ² has n_F − n_C = B (1/λ_F² − 1/λ_C²).
Dispersion Dispersion::by_abbe_number(double index, double abbe) {
    const double span = 1 / squared_micrometres(line_f) - 1 / squared_micrometres(line_c);
    const double b = (index - 1) / (abbe * span);
    return {Formula::cauchy, {index - b / squared_micrometres(line_d), b}};
}

bool Dispersion::spreads() const {
    const auto& c = coefficients;
    switch (formula) {
    case Formula::cauchy: return c[1] != 0 || c[2] != 0;
    case Formula::sellmeier:
        for (std::size_t i = 0; i < 3; ++i)
            if (c[i] != 0 && c[i + 3] != 0) return true;
        return false;
    case Formula::constant: break;
    }
    return false;
}

std::optional<double> Dispersion::pole() const {
    if (formula != Formula::sellmeier) return std::nullopt;
    for (std::size_t i = 0; i < 3; ++i) {
        const double wavelength = 1000 * std::sqrt(coefficients[i + 3]); // NaN: at none
        if (coefficients[i] != 0 && wavelength >= shortest_wavelength && wavelength <= longest_wavelength)
            return wavelength;
    }
    return std::nullopt;
}

double Dispersion::index(double wavelength) const {
    const auto& c = coefficients;
    const double x = squared_micrometres(wavelength);
    switch (formula) {
    case Formula::cauchy: return c[0] + (c[1] + c[2] / x) / x;
    case Formula::sellmeier: {
        double squared = 1;
        for (std::size_t i = 0; i < 3; ++i) squared += c[i] * x / (x - c[i + 3]);
        return squared > 0 ? std::sqrt(squared) : std::numeric_limits<double>::quiet_NaN();
    }
    case Formula::constant: break;
    }
    return 1;
}

} // namespace rayscope
