#pragma once
// Where eye rays come from.

#include "core/math/ray.hpp"
#include "core/math/sequence.hpp"

namespace rayscope {

/// Of a pixel, and of a light's area.
inline constexpr int most_samples = 4096;

struct Camera {
    Vec3d eye{0, 0, 5}, look_at{0}, up{0, 1, 0};
    double field_of_view = 45; ///< degrees, vertical, from edge to edge
    int width = 512, height = 512;
    int samples = 1; ///< at most so many in a pixel; the first one is in its middle
};

/// The eye rays of an image of width × height pixels: unit directions, pixel (0, 0) top left.
class EyeRays {
public:
    EyeRays(const Camera& camera, int width, int height);

    /// Through the point (x, y) in pixels; the middle of pixel (i, j) is (i + ½, j + ½).
    [[nodiscard]] Ray<double> through(double x, double y) const;
    /// Through the place of a pixel's sample: the first one in its middle. So is the mean of the first 4, 8, 16 …
    [[nodiscard]] Ray<double> of(const SampleAddress& sample) const;

    /// A point in the eye's own lengths: to the right, down, and along the view.
    [[nodiscard]] Vec3d from_eye(const Vec3d& point) const;
    [[nodiscard]] const Vec3d& eye() const { return eye_; }
    /// The edge of a pixel at distance 1.
    [[nodiscard]] double pixel() const { return pixel_; }

private:
    double pixel_;
    Vec3d eye_, forward_, right_, down_; // right_ and down_ are one pixel long, at distance 1
    double centre_x_, centre_y_;
};

} // namespace rayscope
