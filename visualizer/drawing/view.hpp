#pragma once
// The picture's camera, and where a point of the world lands in the picture.

#include "visualizer/drawing/region.hpp"

#include <optional>
#include <span>

namespace rayscope::drawing {

/// A rectangle in the picture, in pixels, y down.
struct Area {
    double x = 0, y = 0, width = 0, height = 0;

    [[nodiscard]] double right() const { return x + width; }
    [[nodiscard]] double bottom() const { return y + height; }
    [[nodiscard]] bool overlaps(const Area& other) const {
        return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
    }
    [[nodiscard]] bool contains(const Area& other) const {
        return x <= other.x && y <= other.y && other.right() <= right() && other.bottom() <= bottom();
    }
};

struct Pixel {
    double x = 0, y = 0;
};

/// Length in pixels of the part of a segment that lies within an area.
[[nodiscard]] double length_within(const Pixel& from, const Pixel& to, const Area& area);

/// The part of a segment that is in view, as shares of its length.
struct Part {
    double from = 0, to = 1;
};

/// Drawing happens in view space, where the region is the unit ball around the origin: what a graphics card's single
/// precision can't hold, a detail of 10⁻⁶ or a scene at 10⁶, is gone by then. Move points there in doubles.
class View {
public:
    /// @param back unit, from the region to the camera
    /// @param points world points that are to be seen, within `share` of the area
    View(const Region& region, const Area& area, const Vec3d& back, const Vec3d& up,
         std::span<const Vec3d> points, double share);

    [[nodiscard]] Vec3d to_view(const Vec3d& world) const { return (world - centre_) / scale_; }
    [[nodiscard]] double scale() const { return scale_; } ///< world length of one unit of view space

    /// Of a point in view space, or nothing if it is behind the camera.
    [[nodiscard]] std::optional<Pixel> pixel(const Vec3d& point) const;
    /// View-space length of one pixel at this point.
    [[nodiscard]] double pixel_size(const Vec3d& point) const;
    /// @param margin the area is taken smaller by so many pixels on each side, larger if negative
    [[nodiscard]] std::optional<Part> visible(const Vec3d& from, const Vec3d& to, double margin) const;

    [[nodiscard]] const Area& area() const { return area_; }
    [[nodiscard]] const Vec3d& right() const { return right_; }
    [[nodiscard]] const Vec3d& up() const { return up_; }
    [[nodiscard]] const Vec3d& back() const { return back_; }
    [[nodiscard]] const Vec3d& position() const { return position_; }
    [[nodiscard]] double field_of_view() const; ///< degrees, vertical

private:
    [[nodiscard]] Vec3d to_camera(const Vec3d& point) const; // x right, y up, z ahead

    Area area_;
    Vec3d centre_;
    double scale_;
    Vec3d right_, up_, back_, position_{0};
};

} // namespace rayscope::drawing
