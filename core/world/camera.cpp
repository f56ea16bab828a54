#include "core/world/camera.hpp"

#include <numbers>

namespace rayscope {

EyeRays::EyeRays(const Camera& camera, int width, int height)
    : pixel_(2 * std::tan(camera.field_of_view * std::numbers::pi / 360) / height),
      eye_(camera.eye),
      forward_(normalized(camera.look_at - camera.eye)),
      centre_x_(0.5 * width),
      centre_y_(0.5 * height) {
    right_ = normalized(cross(forward_, camera.up));
    down_ = cross(forward_, right_) * pixel_;
    right_ *= pixel_;
}

Ray<double> EyeRays::through(double x, double y) const {
    return {eye_, normalized(forward_ + (x - centre_x_) * right_ + (y - centre_y_) * down_)};
}

Ray<double> EyeRays::of(const SampleAddress& sample) const {
    constexpr std::uint32_t middle = 1U << 31U; // ½
    SquarePoint place = sobol(std::uint32_t(sample.sample), middle, middle);
    // Each four that follow have their mean in the middle. The first four, one of them in the middle itself, have it an eighth
    // of a pixel before: the others are moved by a sixth, and stay in the quarter and the sixteenth that is theirs.
    if (sample.sample > 0 && sample.sample < 4) place = {place.x + 1.0 / 6, place.y + 1.0 / 6};
    return through(sample.x + place.x, sample.y + place.y);
}

Vec3d EyeRays::from_eye(const Vec3d& point) const {
    const Vec3d v = point - eye_;
    return {dot(v, right_) / pixel_, dot(v, down_) / pixel_, dot(v, forward_)};
}

} // namespace rayscope
