#include "core/accuracy/image_error.hpp"

#include "core/accuracy/colour_difference.hpp"
#include "core/image/srgb.hpp"

#include <cmath>

namespace rayscope {
namespace {

Colour finite_colour(const float* rgb) {
    const Colour colour{rgb[0], rgb[1], rgb[2]};
    return is_finite(colour.x) && is_finite(colour.y) && is_finite(colour.z) ? colour : Colour{0};
}

Colour shown(const Colour& colour) { return glm::clamp(colour, 0.0, 1.0); }

class ErrorOfT {
public:
    void add(const FirstHit& hit, const FirstHit& exact) {
        const double error = std::abs((hit.t - exact.t) + (hit.t_rest - exact.t_rest));
        max_ = maximum(max_, error);
        squares_ += error * error;
        ++count_;
    }
    [[nodiscard]] double max() const { return max_; }
    [[nodiscard]] double rms() const { return count_ > 0 ? std::sqrt(squares_ / double(count_)) : 0; }

private:
    double max_ = 0, squares_ = 0;
    std::size_t count_ = 0;
};

} // namespace

ImageError image_error(const Image& image, const std::vector<FirstHit>& hits, const Reference& reference,
                       Map* map) {
    ImageError error;
    ErrorOfT of_t;
    double difference = 0, total = 0, shown_difference = 0, light = 0, exact_light = 0;
    if (map != nullptr) *map = Map(image.width, image.height);
    for (std::size_t i = 0; i < reference.samples.size(); ++i) {
        const ReferenceSample& exact = reference.samples[i];
        if (hits[i].object != exact.first.object)
            ++error.wrong_pixels;
        else if (hits[i].object != none)
            of_t.add(hits[i], exact.first);

        const Colour colour = finite_colour(&image.rgb[3 * i]);
        const Colour off = colour - exact.colour;
        difference += dot(off, off);
        total += dot(exact.colour, exact.colour);
        light += colour.x + colour.y + colour.z;
        exact_light += exact.colour.x + exact.colour.y + exact.colour.z;
        const auto bytes = srgb_bytes(colour), exact_bytes = srgb_bytes(exact.colour);
        for (std::size_t c = 0; c < 3; ++c) {
            const double step = (bytes[c] - exact_bytes[c]) / 255.0;
            shown_difference += step * step / 3;
        }
        const double delta_e = ciede2000(lab_of(shown(colour)), lab_of(shown(exact.colour)));
        error.delta_e_mean += delta_e / double(reference.samples.size());
        error.delta_e_max = maximum(error.delta_e_max, delta_e);
        if (map != nullptr) map->values[i] = float(delta_e);
    }
    error.t_max = of_t.max();
    error.t_rms = of_t.rms();
    if (total > 0)
        error.relative_rmse = std::sqrt(difference / total);
    else if (difference > 0)
        error.relative_rmse = infinity<double>;
    if (shown_difference > 0)
        error.psnr = 10 * std::log10(double(reference.samples.size()) / shown_difference);
    if (exact_light > 0) error.energy_lost = 1 - light / exact_light;
    return error;
}

} // namespace rayscope
