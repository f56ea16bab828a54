#pragma once
// A window through which a light looks at the scene, cut into cells.

#include "core/world/world.hpp"

#include <optional>
#include <vector>

namespace rayscope {

struct LightView {
    bool parallel = false; ///< of a light that is infinitely far away: z counts along its rays
    Vec3d position{0};
    Vec3d right{1, 0, 0}, down{0, 1, 0}, forward{0, 0, 1};
    double left = -1, top = -1, width = 2, height = 2;    ///< in slopes, or, parallel, in world lengths
    int cells = 1;                                        ///< along each edge
    double columns_per_slope = 0.5, rows_per_slope = 0.5; ///< see cut()

    /// To be called when the window has its place and its number of cells.
    void cut() {
        columns_per_slope = cells / width;
        rows_per_slope = cells / height;
    }
    /// Axes for a view in this direction.
    void look(const Vec3d& direction) {
        forward = normalized(direction);
        const Vec3d size = absolute(forward);
        Vec3d beside{0};
        beside[size.x < size.y ? (size.x < size.z ? 0 : 2) : (size.y < size.z ? 1 : 2)] = 1;
        right = normalized(cross(forward, beside));
        down = cross(forward, right);
    }

    /// A world point as the light sees it.
    [[nodiscard]] Vec3d from_light(const Vec3d& point) const {
        const Vec3d v = parallel ? point : point - position;
        return {dot(v, right), dot(v, down), dot(v, forward)};
    }
    [[nodiscard]] double distance(const Vec3d& seen) const { return parallel ? seen.z : length(seen); }

    /// The cell along one axis, as a real number.
    [[nodiscard]] double column(double x) const { return (x - left) * columns_per_slope; }
    [[nodiscard]] double row(double y) const { return (y - top) * rows_per_slope; }

    struct Cell {
        int x, y;
    };
    /// The cell in which a point is seen; none if it is not seen through this window.
    [[nodiscard]] std::optional<Cell> cell(const Vec3d& seen) const {
        if (!parallel && !(seen.z > 0)) return std::nullopt;
        const double per_slope = parallel ? 1 : 1 / seen.z;
        const double x = column(seen.x * per_slope), y = row(seen.y * per_slope);
        if (!(x >= 0 && x < cells && y >= 0 && y < cells)) return std::nullopt;
        return Cell{int(x), int(y)};
    }
};

/// A window, and how many objects the list of each of its cells holds, row by row.
struct LightWindow {
    LightView view;
    std::vector<std::size_t> held;
};

} // namespace rayscope
