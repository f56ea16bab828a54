#include "core/tracer/added_effects.hpp"

namespace rayscope {

void Spectrum::sample(int count, std::uint32_t seed) {
    lines_.clear();
    const double part = (longest_wavelength - shortest_wavelength) / count;
    const double within = hashed_sobol(0, mixed(seed, std::uint32_t(count))).x;
    Colour sum{0};
    for (int i = 0; i < count; ++i) {
        // As a ray carries it.
        const double wavelength =
            double(float(shortest_wavelength + part * (i + (count > 1 ? within : 0.5))));
        lines_.push_back({wavelength, spectral_colour(wavelength)});
        sum += lines_.back().share;
    }
    // A few lines may leave out a primary; then none of them has a hue.
    const bool white = sum.x > 0 && sum.y > 0 && sum.z > 0;
    for (Line& line : lines_) line.share = white && count > 2 ? line.share / sum : Colour{1.0 / count};
}

Colour beer_lambert(const Colour& absorption, double length) {
    Colour passed{1};
    for (int i = 0; i < 3; ++i)
        if (absorption[i] > 0) passed[i] = std::exp(-absorption[i] * length);
    return passed;
}

Material without_patterns(const Material& material, const Patterns& patterns, const Vec3d& point) {
    Material even = material;
    const auto put = [&](Colour& colour, const std::optional<Pattern>& pattern) {
        if (pattern) colour = pattern->at(point);
    };
    put(even.ambient, patterns.ambient);
    put(even.diffuse, patterns.diffuse);
    put(even.specular, patterns.specular);
    put(even.reflection, patterns.reflection);
    put(even.transmission, patterns.transmission);
    return even;
}

} // namespace rayscope
