#include "visualizer/drawing/view.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope::drawing {
namespace {

constexpr double slope = 0.22; // tangent of half the vertical field of view: little perspective
constexpr double near = 0.05;

/// Where the camera must stand on one of its axes so that points at (offset, depth towards it) fit: of all
/// |offset − centre| ≤ (distance − depth) k the nearest.
struct Fit {
    double distance, centre;
};

template <typename Offset, typename Depth>
Fit fit(std::span<const Vec3d> points, double k, const Offset& offset, const Depth& depth) {
    double above = -infinity<double>, below = -infinity<double>;
    for (const Vec3d& p : points) {
        above = std::max(above, offset(p) + depth(p) * k);
        below = std::max(below, -offset(p) + depth(p) * k);
    }
    return {(above + below) / (2 * k), (above - below) / 2};
}

} // namespace

// Liang and Barsky 1984.
double length_within(const Pixel& from, const Pixel& to, const Area& area) {
    const double dx = to.x - from.x, dy = to.y - from.y;
    double enter = 0, leave = 1;
    const auto clip = [&](double start, double step, double low, double high) {
        if (step == 0) {
            if (start < low || start > high) leave = -1;
            return;
        }
        const double a = (low - start) / step, b = (high - start) / step;
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    };
    clip(from.x, dx, area.x, area.right());
    clip(from.y, dy, area.y, area.bottom());
    return std::max(0.0, leave - enter) * std::hypot(dx, dy);
}

View::View(const Region& region, const Area& area, const Vec3d& back, const Vec3d& up,
           std::span<const Vec3d> points, double share)
    : area_(area),
      centre_(region.centre),
      scale_(region.radius),
      right_(normalized(cross(up, back))),
      up_(normalized(cross(back, right_))),
      back_(back) {
    std::vector<Vec3d> moved{Vec3d{0}};
    if (!points.empty()) moved.clear();
    for (const Vec3d& p : points) moved.push_back(to_view(p));
    const auto depth = [&](const Vec3d& p) { return dot(p, back_); };
    const double k = slope * share;
    const Fit wide =
        fit(moved, k * area.width / area.height, [&](const Vec3d& p) { return dot(p, right_); }, depth);
    const Fit high = fit(moved, k, [&](const Vec3d& p) { return dot(p, up_); }, depth);
    const double distance = std::max({wide.distance, high.distance, 1.2 / slope});
    position_ = right_ * wide.centre + up_ * high.centre + back_ * distance;
}

double View::field_of_view() const { return 2 * std::atan(slope) * 180 / std::numbers::pi; }

Vec3d View::to_camera(const Vec3d& point) const {
    const Vec3d offset = point - position_;
    return {dot(offset, right_), dot(offset, up_), -dot(offset, back_)};
}

std::optional<Pixel> View::pixel(const Vec3d& point) const {
    const Vec3d p = to_camera(point);
    if (!(p.z > near)) return std::nullopt;
    const double pixels = area_.height / (2 * slope * p.z);
    return Pixel{area_.x + area_.width / 2 + p.x * pixels, area_.y + area_.height / 2 - p.y * pixels};
}

double View::pixel_size(const Vec3d& point) const {
    return 2 * slope * std::max(to_camera(point).z, near) / area_.height;
}

std::optional<Part> View::visible(const Vec3d& from, const Vec3d& to, double margin) const {
    const double high = slope * (1 - 2 * margin / area_.height);
    const double wide = slope * (area_.width - 2 * margin) / area_.height;
    // Each side of the view is a linear function of the camera's coordinates, positive inside.
    const auto sides = [&](const Vec3d& p) {
        return std::array{p.z - near, wide * p.z - p.x, wide * p.z + p.x, high * p.z - p.y, high * p.z + p.y};
    };
    const auto at_start = sides(to_camera(from)), at_end = sides(to_camera(to));
    Part part;
    for (std::size_t i = 0; i < at_start.size(); ++i) {
        const double a = at_start[i], b = at_end[i];
        if (!(a > 0) && !(b > 0)) return std::nullopt;
        if (!(a > 0)) part.from = std::max(part.from, a / (a - b));
        if (!(b > 0)) part.to = std::min(part.to, a / (a - b));
    }
    if (!(part.from < part.to)) return std::nullopt;
    return part;
}

} // namespace rayscope::drawing
