#pragma once
// Balls in groups: their centres and radii, in floats.

#include "core/boxes/groups.hpp"
#include "core/math/lanes.hpp"
#include "core/stage/balls.hpp"

#include <experimental/simd>

namespace rayscope {

/// Leaves out what a line passes by far enough that no rounding could tell otherwise; a kernel answers for the rest.
class BallGroups : public Groups<4> {
public:
    /// @param ball a solid with is_ball
    template <Numbers N> void add(const Solid<N>& ball, std::uint32_t object, double scale) {
        const auto centre = as<float>(as<double>(ball.transform.translation()) * scale);
        Groups::add(
            {centre.x, centre.y, centre.z, float(double(std::get<Sphere<N>>(ball.shape).radius) * scale)},
            object);
    }

    /// Calls hit(object) for each of the balls first … last − 1, which are whole groups, that may have a crossing with
    /// 0 ≤ t ≤ reach, until it returns true.
    /// @return the ball after the one that ended it, or `last`
    template <typename OnHit>
    std::size_t each_near(const GroupRay& ray, double reach, std::size_t first, std::size_t last,
                          const OnHit& hit) const {
        const auto near = [&, limit = ray.reach(reach)](const float* numbers, std::size_t count) {
            return near_of(ray, limit, numbers, count);
        };
        return this->each(first, last, near, hit);
    }

private:
    using Lanes = std::experimental::native_simd<float>;

    // Bit i: the Sphere kernel may find a crossing of ball i in the range. With u half a float's ε, and S the ray's size,
    // each coordinate of a centre seen from the origin is off by 3uS, and what follows from it, the middle of the chord
    // and the line's distance from the centre, by 22uS and 34uS at most. 64uS also hold the rounding of the radius, and
    // what a kernel's crossing may lie beside its ball.
    static unsigned near_of(const GroupRay& ray, float reach, const float* numbers, std::size_t count) {
        const auto margin = float(32 * double(epsilon<float>) * ray.size);
        unsigned near = 0;
        for (std::size_t part = 0; part < group_lanes; part += Lanes::size()) {
            const auto column = [&](std::size_t which) {
                return Lanes(numbers + which * count + part, std::experimental::element_aligned);
            };
            const Lanes x = column(0) - ray.x, y = column(1) - ray.y, z = column(2) - ray.z,
                        radius = column(3) + margin;
            const Lanes middle = x * ray.dx + y * ray.dy + z * ray.dz;
            const Lanes px = x - middle * ray.dx, py = y - middle * ray.dy, pz = z - middle * ray.dz;
            const auto met = (radius * radius >= px * px + py * py + pz * pz) & (middle + radius >= 0.0F) &
                             (reach + radius >= middle);
            near |= bits_of(met) << part;
        }
        return near;
    }
};

} // namespace rayscope
