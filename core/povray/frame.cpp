#include "core/povray/frame.hpp"

#include <cmath>

namespace rayscope::povray {
namespace {

// POV-Ray's shortest distance is a hundredth of a solid of this size.
constexpr double least_size = 0.1;
constexpr double longest_distance = 1e6;
// Coordinates that are so many times as large as the scene leave its surfaces too few digits.
constexpr double farthest_off = 1e4;

struct Sizes {
    double smallest = infinity<double>,
           reach = 0; // of a bounded object; from the eye to the farthest of them
};

Sizes sizes_of(const Scene& scene, const WorldBase& world) {
    Sizes sizes;
    for (const Object& object : world.objects) {
        if (!object.bounds.bounded()) continue;
        const Vec3d low = object.bounds.low, high = object.bounds.high;
        const double size = largest_component(high - low);
        if (size > 0) sizes.smallest = minimum(sizes.smallest, size);
        const Vec3d away = absolute(low - scene.camera.eye), far = absolute(high - scene.camera.eye);
        sizes.reach = maximum(sizes.reach, maximum(largest_component(away), largest_component(far)));
    }
    sizes.reach = maximum(sizes.reach, length(scene.camera.look_at - scene.camera.eye));
    sizes.smallest = minimum(sizes.smallest, sizes.reach);
    return sizes;
}

} // namespace

Mat4d Frame::matrix(Mat4d m) const {
    for (int column = 0; column < 4; ++column) {
        const Vec3d moved = column < 3 ? scale * Vec3d{m[column]} : point(Vec3d{m[column]});
        for (int row = 0; row < 3; ++row) m[column][row] = moved[row];
    }
    return m;
}

Frame frame_of(const Scene& scene, const WorldBase& world) {
    const Sizes sizes = sizes_of(scene, world);
    Frame frame;
    if (length(scene.camera.look_at) > farthest_off * sizes.reach) frame.origin = scene.camera.look_at;
    if (sizes.smallest < least_size || sizes.reach > longest_distance) {
        // Powers of ten keep the author's digits.
        const double wanted = sizes.smallest < least_size ? std::ceil(std::log10(1 / sizes.smallest)) : 0;
        const double possible = std::floor(std::log10(longest_distance / sizes.reach));
        frame.scale = std::pow(10, minimum(wanted, possible));
    }
    return frame;
}

} // namespace rayscope::povray
