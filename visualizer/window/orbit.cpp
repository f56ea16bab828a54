#include "visualizer/window/orbit.hpp"

#include "visualizer/drawing/framing.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope::window {
namespace {

// A View without points stands so many radii from the middle of its region.
const double radii_away = drawing::View({}, {0, 0, 1, 1}, {0, 0, 1}, {0, 1, 0}, {}, 1).position().z;

Vec3d turned(const Vec3d& v, const Vec3d& axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + cross(axis, v) * s + axis * (dot(axis, v) * (1 - c));
}

} // namespace

drawing::View Orbit::view(const drawing::Area& area) const {
    return {drawing::Region{pivot, radius, {}}, area, back, up, {}, 1};
}

void Orbit::turn(double dx, double dy) {
    constexpr double speed = 0.008, pole = 0.985;
    back = normalized(turned(back, up, -dx * speed));
    const Vec3d right = normalized(cross(up, back)), next = normalized(turned(back, right, -dy * speed));
    if (std::abs(dot(next, up)) < pole) back = next;
}

void Orbit::shift(const drawing::View& view, double dx, double dy) {
    const double pixel = view.pixel_size(Vec3d{0}) * view.scale();
    pivot += (view.right() * -dx + view.up() * dy) * pixel;
}

void Orbit::zoom(double factor) { radius = std::clamp(radius * factor, 1e-12, 1e12); }

void Orbit::look(const Vec3d& from, const Vec3d& to) {
    const double away = length(from - to);
    if (!(away > 0) || !std::isfinite(away)) return;
    pivot = to;
    back = (from - to) / away;
    radius = away / radii_away;
    // Along the upward direction any other one does.
    if (std::abs(dot(back, up)) > 0.999)
        back = normalized(back + normalized(cross(up, Vec3d{up.y, up.z, up.x})) * 0.05);
}

Orbit framed_orbit(const Trace& trace, const Scene& scene, const drawing::Region& region,
                   const drawing::Area& area, int ray) {
    const drawing::View view = drawing::framed(trace, scene, region, area, ray);
    Orbit orbit;
    orbit.back = view.back();
    const Vec3d up = normalized(scene.camera.up);
    orbit.up = length(up) > 0.5 ? up : Vec3d{0, 1, 0};
    const double along = dot(view.position(), view.back());
    orbit.pivot = region.centre + (view.position() - view.back() * along) * region.radius;
    orbit.radius = region.radius * along / radii_away;
    return orbit;
}

} // namespace rayscope::window
