#include "core/accuracy/colour_difference.hpp"

#include <cmath>
#include <numbers>

namespace rayscope {
namespace {

constexpr double degree = std::numbers::pi / 180;

double cube_root_with_foot(double x) {
    constexpr double foot = 6.0 / 29;
    return x > foot * foot * foot ? std::cbrt(x) : x / (3 * foot * foot) + 4.0 / 29;
}

// c⁷ / (c⁷ + 25⁷), rooted: how saturated a chroma is.
double saturation(double chroma) {
    const double seventh = std::pow(chroma / 25, 7);
    return std::sqrt(seventh / (seventh + 1));
}

// Of (a, b): degrees in 0 … 360; grey has hue 0.
double hue(double a, double b) {
    const double angle = a == 0 && b == 0 ? 0 : std::atan2(b, a) / degree;
    return angle < 0 ? angle + 360 : angle;
}

double square(double x) { return x * x; }

} // namespace

Vec3d lab_of(const Colour& linear_srgb) {
    // IEC 61966-2-1: from linear sRGB to XYZ, its white at Y = 1.
    const double r = linear_srgb.x, g = linear_srgb.y, b = linear_srgb.z;
    const double x = (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505;
    const double y = 0.2126 * r + 0.7152 * g + 0.0722 * b;
    const double z = (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.0890;
    const double fx = cube_root_with_foot(x), fy = cube_root_with_foot(y), fz = cube_root_with_foot(z);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

double ciede2000(const Vec3d& lab, const Vec3d& other) {
    const double chroma_mean = (std::hypot(lab.y, lab.z) + std::hypot(other.y, other.z)) / 2;
    const double stretch = 1.5 - saturation(chroma_mean) / 2;
    const double a1 = stretch * lab.y, a2 = stretch * other.y;
    const double c1 = std::hypot(a1, lab.z), c2 = std::hypot(a2, other.z);
    const double h1 = hue(a1, lab.z), h2 = hue(a2, other.z);

    double turn = 0, h_mean = h1 + h2; // where one is grey its hue, 0, adds nothing
    if (c1 * c2 > 0) {
        const bool across_red = std::abs(h2 - h1) > 180;
        turn = across_red ? h2 - h1 - std::copysign(360, h2 - h1) : h2 - h1;
        h_mean = (h1 + h2) / 2;
        if (across_red) h_mean += h_mean < 180 ? 180 : -180;
    }
    const double dL = other.x - lab.x, dC = c2 - c1;
    const double dH = 2 * std::sqrt(c1 * c2) * std::sin(turn / 2 * degree);

    const double c_mean = (c1 + c2) / 2;
    const double middle = square((lab.x + other.x) / 2 - 50);
    const double T = 1 - 0.17 * std::cos((h_mean - 30) * degree) + 0.24 * std::cos(2 * h_mean * degree) +
                     0.32 * std::cos((3 * h_mean + 6) * degree) - 0.20 * std::cos((4 * h_mean - 63) * degree);
    const double SL = 1 + 0.015 * middle / std::sqrt(20 + middle);
    const double SC = 1 + 0.045 * c_mean, SH = 1 + 0.015 * c_mean * T;
    const double rotation = std::sin(60 * degree * std::exp(-square((h_mean - 275) / 25)));
    const double RT = -2 * saturation(c_mean) * rotation;
    const double l = dL / SL, c = dC / SC, h = dH / SH;
    return std::sqrt(std::fmax(0, l * l + c * c + h * h + RT * c * h));
}

} // namespace rayscope
