#pragma once
// What the tracer with all effects does besides the classic one's work.

#include "core/refraction/fresnel.hpp"
#include "core/shading/spectrum.hpp"
#include "core/tracer/budget.hpp"
#include "core/tracer/interaction.hpp"

namespace rayscope {

/// What a ray carries from boundary to boundary, besides the surfaces that it leaves.
template <Scalar T> struct RayState {
    Ray<T> ray;
    Budget budget;
};
static_assert(sizeof(RayState<double>) <= 128);

/// The wavelengths of one sample, in nm: one from each of equal parts of the spectrum, so that neighbouring samples
/// fill each other's gaps. Their colours add up to white.
class Spectrum {
public:
    struct Line {
        double wavelength;
        Colour share;
    };

    void clear() { lines_.clear(); }
    [[nodiscard]] bool empty() const { return lines_.empty(); }
    /// @param seed of the sample
    void sample(int count, std::uint32_t seed);
    [[nodiscard]] const std::vector<Line>& lines() const { return lines_; }

private:
    std::vector<Line> lines_;
};

/// exp(−absorption · length), the law of Beer and Lambert; of an endless way, what is not absorbed at all.
[[nodiscard]] Colour beer_lambert(const Colour& absorption, double length);

/// The materials of a hit with their patterns' values put in.
struct EvenMaterials {
    Material own, wall;
};

[[nodiscard]] Material without_patterns(const Material& material, const Patterns& patterns,
                                        const Vec3d& point);

/// Where a crossing lies in its solid's own space: beneath the surface by as much as it may be off, so that a face that
/// lies in a boundary of a pattern has one colour.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Vec3d pattern_point(const Solid<N>& solid, const Ray<T>& ray, T t, int face) {
    const Vec3<T> p = solid.transform.to_object(ray).at(t);
    const Vec3<T> n = std::visit([&](const auto& s) { return s.normal(p, face); }, solid.shape);
    const T size = dot(n, n);
    if (!(size > T(0))) return as<double>(p);
    return as<double>(p - n * (T(4) * solid.surface_distance(solid.point_error(ray, t), n) / size));
}

/// The medium's share of light that a shadow ray loses from its start to `distance`: of each stretch in an absorbing
/// medium, by priority, from the inside lists of all that transmits.
template <Numbers N, Scalar T = ScalarOf<N>> class AbsorbedWay {
public:
    /// Calls each(medium, length, passed) for the stretches that absorb, from the start on.
    template <typename Each>
    void walk(const World<N>& world, const Ray<T>& ray, T distance, const Leaving<T>& leaving, Work<T>& work,
              const Each& each) {
        gather(world, ray, distance, leaving, work);
        T start = T(0);
        std::size_t next = 0;
        while (start < distance) {
            const T end = next < turns_.size() ? turns_[next].t : distance;
            const Id here = medium_now(world);
            if (here != none && end > start) absorb(world, here, double(end - start), each);
            if (next == turns_.size()) break;
            turn(turns_[next++]);
            start = end;
        }
    }

    /// The same by the notes' rule: behind a wall that is not entered there is air.
    /// @param medium at the start
    /// @param blockers the walls on the way
    template <typename Each>
    void walk_by_the_notes(const World<N>& world, T distance, Id medium,
                           const std::vector<Blocker<T>>& blockers, const Each& each) {
        T start = T(0);
        const auto go_to = [&](T end) {
            if (medium != none && end > start) absorb(world, medium, double(end - start), each);
            start = end;
        };
        for (const Blocker<T>& wall : blockers) {
            go_to(wall.t);
            medium = world.objects[wall.object].has_volume && wall.entering ? Id(wall.object) : none;
        }
        go_to(distance);
    }

private:
    struct Turn {
        T t;
        std::uint32_t object;
        bool entering;
    };

    template <typename Each>
    static void absorb(const World<N>& world, Id medium, double length, const Each& each) {
        const Material& material = world.material_of(std::uint32_t(medium));
        if (material.absorbs()) each(medium, length, beer_lambert(material.absorption, length));
    }

    void gather(const World<N>& world, const Ray<T>& ray, T distance, const Leaving<T>& leaving,
                Work<T>& work) {
        turns_.clear();
        inside_.clear();
        const Vec3d to = as<double>(ray.at(distance)), from = as<double>(ray.origin);
        for (const std::uint32_t object : world.media.all()) {
            Box<double> way;
            way.include(from);
            way.include(to);
            if (is_finite(distance) && !world.objects[object].bounds.overlaps(way)) continue;
            bool inside = false;
            for (const Crossing<T>& c : crossings(world, object, ray, leaving.of(object), work)) {
                if (c.t >= distance) break;
                if (c.t > T(0))
                    turns_.push_back({c.t, object, c.entering});
                else
                    inside = c.entering;
            }
            if (const auto* start = leaving.of(object); start != nullptr) inside = start->starts_inside;
            if (inside) inside_.push_back(object);
        }
        std::sort(turns_.begin(), turns_.end(), [](const Turn& a, const Turn& b) {
            return a.t < b.t || (a.t == b.t && a.object < b.object);
        });
    }
    void turn(const Turn& turn) {
        if (turn.entering)
            inside_.push_back(turn.object);
        else
            std::erase(inside_, turn.object);
    }
    [[nodiscard]] Id medium_now(const World<N>& world) const {
        Containing here;
        for (const std::uint32_t object : inside_) here.offer(world.objects[object].priority, Id(object));
        return here.medium();
    }

    std::vector<Turn> turns_;
    std::vector<std::uint32_t> inside_;
};

} // namespace rayscope
