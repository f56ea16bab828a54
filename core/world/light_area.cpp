#include "core/world/light_area.hpp"

#include <cmath>
#include <numbers>

namespace rayscope {
namespace {

struct DiskPoint {
    double x, y;
};

// Shirley and Chiu (1997): concentric squares become concentric circles, so that what is even stays even.
DiskPoint on_disk(const SquarePoint& square) {
    const double a = 2 * square.x - 1, b = 2 * square.y - 1;
    if (a == 0 && b == 0) return {0, 0};
    constexpr double quarter = std::numbers::pi / 4;
    const bool wide = std::abs(a) > std::abs(b);
    const double r = wide ? a : b, angle = wide ? quarter * (b / a) : 2 * quarter - quarter * (a / b);
    return {r * std::cos(angle), r * std::sin(angle)};
}

} // namespace

Vec3d LightArea::offset(const SquarePoint& square, const Vec3d& towards) const {
    switch (shape) {
    case Shape::rectangle: return (2 * square.x - 1) * u + (2 * square.y - 1) * v;
    case Shape::disk: {
        const DiskPoint p = on_disk(square);
        return radius * (p.x * u + p.y * v);
    }
    case Shape::sphere: {
        const DiskPoint p = on_disk(square);
        const double distance = length(towards), sine = radius / distance;
        const Vec3d forward = distance > 0 ? towards / distance : Vec3d{1, 0, 0}, sideways = across(forward);
        const Vec3d aside = p.x * sideways + p.y * cross(forward, sideways);
        if (!(sine < 1)) return radius * aside;
        // Equal parts of the cone around it: the height of a cap goes with the square of its share of the disk.
        const double share = p.x * p.x + p.y * p.y;
        const double cap =
            sine * sine / (1 + std::sqrt((1 - sine) * (1 + sine))); // 1 − cos of the outline's angle
        const double versine = share * cap, cosine = 1 - versine;
        const Vec3d direction = cosine * forward + std::sqrt(cap * (2 - versine)) * aside;
        const double off =
            distance * distance * versine * (2 - versine); // of the centre from this line, squared
        const double way = distance * cosine - std::sqrt(maximum(radius * radius - off, 0.0));
        return way * direction - towards;
    }
    case Shape::point: break;
    }
    return Vec3d{0};
}

} // namespace rayscope
