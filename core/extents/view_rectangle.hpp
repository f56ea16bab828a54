#pragma once
// Where an object is seen from one point: the notes' projective extent.

#include "core/stage/balls.hpp"

#include <optional>

namespace rayscope {

/// Slopes x / z and y / z, and the least distance.
struct ViewRectangle {
    double left = infinity<double>, top = infinity<double>;
    double right = -infinity<double>, bottom = -infinity<double>;
    double nearest = 0; ///< from the point to the object, never rounded up

    [[nodiscard]] static ViewRectangle everything(double nearest) {
        const double all = infinity<double>;
        return {-all, -all, all, all, nearest};
    }
    void include(double x, double y) {
        left = minimum(left, x);
        right = maximum(right, x);
        top = minimum(top, y);
        bottom = maximum(bottom, y);
    }
};

/// In float, rounded towards −∞, or +∞, by more than float rounds.
[[nodiscard]] inline float below(double x) {
    const float rounded = float(x - magnitude(x) * 8 * double(epsilon<float>));
    // Beyond a float's range, and between its least number and 0, it is the rounding that decides.
    return double(rounded) > x ? std::nextafter(rounded, -infinity<float>) : rounded;
}
[[nodiscard]] inline float above(double x) { return -below(-x); }

/// The slopes a / z between which a ball lies whose centre is (a, z) in the plane of the two: tangents through the eye.
/// Its radius must be less than z.
struct Slopes {
    double low, high;
};
[[nodiscard]] inline Slopes tangents(double a, double z, double radius) {
    const double root = radius * std::sqrt(fma(a, a, (z - radius) * (z + radius)));
    const double below = (z - radius) * (z + radius);
    return {(a * z - root) / below, (a * z + root) / below};
}

/// The rectangles of a world's objects.
template <Numbers N> class Views {
public:
    /// @param margin how far rounding may put a crossing beside its object: world length
    Views(const World<N>& world, double margin) : world_(world), margin_(margin) {}

    /// The rectangle of an object that does not stand apart; nothing if it lies behind the eye. What reaches the eye's plane is
    /// seen everywhere. All is a little larger than rounding can make a difference.
    /// @param frame called as frame(point): a world point as (x, y, z) from the eye, z along the view, in unit lengths
    template <typename Frame>
    [[nodiscard]] std::optional<ViewRectangle> rectangle(const Object& object, const Frame& frame) const {
        if (const auto ball = deciding_ball(world_, object)) return of_ball(world_.solids[*ball], frame);
        return of_box(object, frame);
    }

    /// The same from infinitely far away: (x, y) themselves, and the least z.
    template <typename Frame>
    [[nodiscard]] ViewRectangle parallel_rectangle(const Object& object, const Frame& frame) const {
        ViewRectangle seen;
        seen.nearest = infinity<double>;
        const auto include = [&](const Vec3d& p, double radius) {
            radius += slack * length(p) + margin_;
            seen.include(p.x - radius, p.y - radius);
            seen.include(p.x + radius, p.y + radius);
            seen.nearest = minimum(seen.nearest, p.z - radius);
        };
        if (const auto ball = deciding_ball(world_, object))
            include(frame(as<double>(world_.solids[*ball].transform.translation())),
                    double(std::get<Sphere<N>>(world_.solids[*ball].shape).radius));
        else
            for (const Vec3d& corner : corners(object)) include(frame(corner), 0);
        return seen;
    }

private:
    static constexpr double slack =
        0x1p22 * epsilon<double>; // relative: far above rounding, far below a pixel

    template <typename Frame>
    [[nodiscard]] std::optional<ViewRectangle> of_ball(const Solid<N>& ball, const Frame& frame) const {
        const Vec3d centre = frame(as<double>(ball.transform.translation()));
        const double distance = length(centre);
        const double radius =
            double(std::get<Sphere<N>>(ball.shape).radius) * (1 + slack) + slack * distance + margin_;
        if (centre.z < -radius) return std::nullopt;
        const double nearest = maximum(0.0, distance - radius);
        if (!(centre.z > radius * (1 + slack))) return ViewRectangle::everything(nearest);
        const Slopes x = tangents(centre.x, centre.z, radius), y = tangents(centre.y, centre.z, radius);
        return ViewRectangle{x.low, y.low, x.high, y.high, nearest};
    }

    template <typename Frame>
    [[nodiscard]] std::optional<ViewRectangle> of_box(const Object& object, const Frame& frame) const {
        auto corners = this->corners(object);
        double farthest = -infinity<double>, least = infinity<double>, size = 0;
        for (Vec3d& corner : corners) {
            corner = frame(corner);
            size = maximum(size, length(corner));
            least = minimum(least, corner.z);
            farthest = maximum(farthest, corner.z);
        }
        const double margin = slack * size + margin_;
        if (farthest < -margin) return std::nullopt;
        const double nearest = distance_to(corners, margin);
        if (!(least > 2 * margin)) return ViewRectangle::everything(nearest);
        ViewRectangle seen;
        for (const Vec3d& c : corners)
            for (const double off : {-margin, margin}) {
                seen.include((c.x + off) / (c.z - margin), (c.y + off) / (c.z - margin));
                seen.include((c.x + off) / (c.z + margin), (c.y + off) / (c.z + margin));
            }
        seen.nearest = nearest;
        return seen;
    }

    // Of the generic's box, moved by M; of a compound's box, which is the world's.
    [[nodiscard]] std::array<Vec3d, 8> corners(const Object& object) const {
        const Mat4d m =
            object.is_compound ? Mat4d{1} : as_double(world_.solids[object.index].transform.matrix());
        const Box<double> box = object.is_compound ? object.bounds : object_box(object);
        std::array<Vec3d, 8> result;
        for (std::size_t i = 0; i < 8; ++i) {
            Vec3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = (i >> axis & 1U) != 0 ? box.high[axis] : box.low[axis];
            result[i] = Vec3d{m * glm::vec<4, double>{p, 1.0}};
        }
        return result;
    }

    // From the eye to the ball around the corners: less than to any point of the box.
    [[nodiscard]] static double distance_to(const std::array<Vec3d, 8>& corners, double margin) {
        Vec3d middle{0};
        for (const Vec3d& c : corners) middle += c / 8.0;
        double radius = 0;
        for (const Vec3d& c : corners) radius = maximum(radius, length(c - middle));
        return maximum(0.0, length(middle) - radius - margin);
    }

    [[nodiscard]] Box<double> object_box(const Object& object) const {
        return std::visit([](const auto& s) { return as<double>(s.bounds()); },
                          world_.solids[object.index].shape);
    }
    template <Scalar T> [[nodiscard]] static Mat4d as_double(const Mat4<T>& m) {
        Mat4d result;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) result[j][i] = double(m[j][i]);
        return result;
    }

    const World<N>& world_;
    double margin_;
};

} // namespace rayscope
