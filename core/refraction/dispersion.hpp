#pragma once
// The index of refraction as a function of the wavelength.

#include <array>
#include <cstdint>
#include <optional>

namespace rayscope {

/// Wavelengths in nm for which glass makers state indices: of helium's yellow line, hydrogen's blue and its red one.
inline constexpr double line_d = 587.5618, line_f = 486.1327, line_c = 656.2725;
/// The part of the spectrum that is sampled, in nm.
inline constexpr double shortest_wavelength = 400, longest_wavelength = 700;

/// No formula: the index is the same for all colours.
struct Dispersion {
    enum class Formula : std::uint8_t { constant, cauchy, sellmeier };

    Formula formula = Formula::constant;
    /// Cauchy: A, B (μm²), C (μm⁴). Sellmeier: B₁, B₂, B₃, C₁, C₂, C₃ (μm²).
    std::array<double, 6> coefficients{};

    /// Cauchy's formula through the index n_d with the Abbe number V = (n_d − 1) / (n_F − n_C).
    [[nodiscard]] static Dispersion by_abbe_number(double index, double abbe);

    /// False, too, for a formula that gives all wavelengths one index.
    [[nodiscard]] bool spreads() const;
    /// Whether a term of Sellmeier's formula grows beyond all bounds at a wavelength of the part that is sampled, nm.
    [[nodiscard]] std::optional<double> pole() const;
    [[nodiscard]] bool operator==(const Dispersion&) const = default;
    /// @param wavelength in a vacuum, nm
    /// @return n; of Sellmeier's formula NaN where it has no meaning
    [[nodiscard]] double index(double wavelength) const;
};

} // namespace rayscope
