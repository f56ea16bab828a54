#pragma once
// The three kinds of rays that a tracer asks for, as lists: one after the other through any rival.

#include "bench/support/easy_rays.hpp"
#include "core/stage/search.hpp"
#include "core/world/camera.hpp"

namespace rayscope::bench {

struct RaySets {
    std::vector<Ray<double>> eye; ///< one for each pixel, row by row
    std::vector<Ray<double>>
        other; ///< from each hit into a random direction of its hemisphere: no two go together
    std::vector<Ray<double>> shadow; ///< from each hit that faces the light, t = 1 at the light
};

/// A little above the surface, so that a rival without our leaving surfaces may trace them too.
template <typename Stage>
[[nodiscard]] RaySets ray_sets(const World<double>& world, const Stage& stage, const Camera& camera,
                               const Vec3d& light) {
    RaySets sets;
    Random random;
    Work<double> work;
    NullRecorder recorder;
    const Leaving<double> nothing;
    const EyeRays eyes(camera, camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const Ray<double> ray = eyes.through(x + 0.5, y + 0.5);
            sets.eye.push_back(ray);
            const auto hit = stage.closest(ray, Range<double>{0}, nothing, work, recorder);
            if (!hit) continue;
            const auto& [t, object, surface, entering, crowded] = *hit;
            Vec3d n = normalized(world.solids[surface.solid].normal(ray, t, surface.face));
            if (dot(n, ray.direction) > 0) n = -n;
            const Vec3d from = ray.at(t) + 1e-4 * n;
            Vec3d away = random.point();
            while (!(dot(away, away) <= 1) || !(dot(away, away) > 0.01)) away = random.point();
            away = normalized(away);
            sets.other.push_back({from, dot(away, n) < 0 ? -away : away});
            if (dot(n, light - from) > 0) sets.shadow.push_back({from, light - from});
        }
    return sets;
}

/// What came of a list of rays, to be compared before any clock starts.
struct RaySum {
    std::size_t hits = 0;
    double distance = 0; ///< sum of all t

    friend bool operator==(const RaySum&, const RaySum&) = default;
};

template <typename Stage>
[[nodiscard]] RaySum nearest_of(const Stage& stage, const std::vector<Ray<double>>& rays, Work<double>& work,
                                RayKind kind) {
    NullRecorder recorder;
    const Leaving<double> nothing;
    RaySum sum;
    for (const Ray<double>& ray : rays)
        if (const auto hit = stage.closest(RayUse{kind}, ray, Range<double>{0}, nothing, work, recorder)) {
            ++sum.hits;
            sum.distance += (*hit).t;
        }
    return sum;
}

template <typename Stage>
[[nodiscard]] RaySum blocked_of(const Stage& stage, const std::vector<Ray<double>>& rays,
                                Work<double>& work) {
    NullRecorder recorder;
    const Leaving<double> nothing;
    RaySum sum;
    for (const Ray<double>& ray : rays)
        if (stage.blocked(RayUse{RayKind::shadow}, ray, Range<double>{0, 1}, nothing, work, recorder))
            ++sum.hits;
    return sum;
}

} // namespace rayscope::bench
