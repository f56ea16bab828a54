#include "core/world/camera.hpp"

#include <numbers>

namespace rayscope {

EyeRays::EyeRays(const Camera& camera, int width, int height)
    : eye_(camera.eye),
      forward_(normalized(camera.look_at - camera.eye)),
      centre_x_(0.5 * width),
      centre_y_(0.5 * height) {
    const double half_angle = camera.field_of_view * std::numbers::pi / 360;
    const double pixel = 2 * std::tan(half_angle) / height;
    right_ = normalized(cross(forward_, camera.up));
    down_ = cross(forward_, right_) * pixel;
    right_ *= pixel;
}

Ray<double> EyeRays::through(double x, double y) const {
    return {eye_, normalized(forward_ + (x - centre_x_) * right_ + (y - centre_y_) * down_)};
}

} // namespace rayscope
