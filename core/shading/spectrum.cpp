#include "core/shading/spectrum.hpp"

#include <cmath>

namespace rayscope {
namespace {

// A Gaussian with a width of its own on either side of its mean.
struct Lobe {
    double height, mean, rise, fall; // nm⁻¹

    [[nodiscard]] double at(double wavelength) const {
        const double x = (wavelength - mean) * (wavelength < mean ? rise : fall);
        return height * std::exp(-0.5 * x * x);
    }
};

constexpr Lobe x_lobes[] = {
    {0.362, 442.0, 0.0624, 0.0374}, {1.056, 599.8, 0.0264, 0.0323}, {-0.065, 501.1, 0.0490, 0.0382}};
constexpr Lobe y_lobes[] = {{0.821, 568.8, 0.0213, 0.0247}, {0.286, 530.9, 0.0613, 0.0322}};
constexpr Lobe z_lobes[] = {{1.217, 437.0, 0.0845, 0.0278}, {0.681, 459.0, 0.0385, 0.0725}};

template <std::size_t count> double sum_of(const Lobe (&lobes)[count], double wavelength) {
    double sum = 0;
    for (const Lobe& lobe : lobes) sum += lobe.at(wavelength);
    return sum;
}

} // namespace

Colour spectral_colour(double wavelength) {
    const double x = sum_of(x_lobes, wavelength), y = sum_of(y_lobes, wavelength),
                 z = sum_of(z_lobes, wavelength);
    // IEC 61966-2-1: XYZ to linear sRGB.
    const Colour rgb{3.2406 * x - 1.5372 * y - 0.4986 * z, -0.9689 * x + 1.8758 * y + 0.0415 * z,
                     0.0557 * x - 0.2040 * y + 1.0570 * z};
    return maximum_of(rgb, Colour{0});
}

} // namespace rayscope
