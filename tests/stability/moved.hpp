#pragma once
// A whole scene moved, and the record of a ray in it compared with the record of the moved ray.

#include "core/rayscope.hpp"
#include "tests/support/exact.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/matrices.hpp"

#include <algorithm>

namespace rayscope::test {

/// A similarity: x → matrix · x, lengths times `scale`; mirrored if its determinant is negative.
struct Motion {
    Mat4d matrix{1};
    double scale = 1;
    bool mirrored = false;
};

/// Solids, camera and lights. The world matrix of an operand is C·M, with C of its compounds: each C is conjugated,
/// (S C S⁻¹)(S M) = S C M; one that is 1 stays it.
[[nodiscard]] inline Scene moved(Scene scene, const Motion& motion) {
    const Mat4d& m = motion.matrix;
    Camera& camera = scene.camera;
    camera.eye = transformed_point(m, camera.eye);
    camera.look_at = transformed_point(m, camera.look_at);
    camera.up = transformed_vector(m, camera.up) / motion.scale;
    for (SceneLight& light : scene.lights) {
        light.position = light.directional ? normalized(transformed_vector(m, light.position))
                                           : transformed_point(m, light.position);
        const bool disk = light.area.shape == LightArea::Shape::disk; // its sides are unit
        light.area.radius *= motion.scale;
        light.area.u = transformed_vector(m, light.area.u) / (disk ? motion.scale : 1);
        light.area.v = transformed_vector(m, light.area.v) / (disk ? motion.scale : 1);
    }
    for (SceneMaterial& material : scene.materials) material.absorption /= motion.scale;
    for (SceneGeneric& generic : scene.generics) generic.matrix = m * generic.matrix;
    for (SceneCompound& compound : scene.compounds)
        if (compound.matrix != Mat4d{1}) compound.matrix = m * compound.matrix * glm::inverse(m);
    return scene;
}

/// What two records of the same ray tell of each other.
struct Agreement {
    std::string wrong; ///< empty: nothing
    int rays = 0;      ///< compared
    int parted = 0;    ///< went different ways where rounding decides
    double t = 0, moved_t = 0, bound = 0,
           moved_bound = 0; ///< of the place where they first did, or else of the first hit
};

/// Follows both records from the eye on. Neither ray is exact, nor are the moved solids; what that amounts to is known:
///  – how far the moved ray is from the motion of the other one, at the hit: measured, in 113 bits. It holds all that
///    the rays before have done to it, so that each hit is judged by itself;
///  – how far the moved surface is from the motion of the other one: at most 32ε |S| (|C M p| + …), for each element of a
///    product of up to four matrices is a sum of four products, rounded seven times, and stored;
/// both are world lengths, which error_bound turns into t. The tolerance is the sum of both error bounds with them.
class Comparison {
public:
    Comparison(const World<double>& world, const World<double>& moved_world, const Motion& motion)
        : world_(world), moved_(moved_world), motion_(motion) {}

    [[nodiscard]] Agreement compare(const Ray<double>& ray, const Ray<double>& moved_ray) {
        const Recording here = record(world_, ray), there = record(moved_, moved_ray);
        result_ = {};
        follow(here.rays, 0, there.rays, 0);
        return result_;
    }

private:
    using Rays = std::vector<TracedRay>;
    struct Place {
        Ray<double> ray, moved_ray;
    };

    void follow(const Rays& here, int i, const Rays& there, int j) {
        if (!result_.wrong.empty()) return;
        const TracedRay &a = here[std::size_t(i)], &b = there[std::size_t(j)];
        const Place place{{a.start().origin, a.start().direction}, {b.start().origin, b.start().direction}};
        ++result_.rays;
        if (a.start().kind == RayKind::shadow) {
            const bool same = a.find<RayFinished>()->colour == b.find<RayFinished>()->colour;
            if (!same) part(doubtful_line(place, b.start().reach), "a shadow differs", place);
            return;
        }
        const auto *hit = a.find<BoundaryChosen>(), *moved_hit = b.find<BoundaryChosen>();
        if (hit == nullptr && moved_hit == nullptr) return;
        if (hit == nullptr || moved_hit == nullptr) {
            const double t = hit != nullptr ? hit->boundary.t * motion_.scale : moved_hit->boundary.t;
            part(doubtful(place, t), "a hit of one alone, at " + hex(t), place);
            return;
        }
        const double t = hit->boundary.t * motion_.scale, moved_t = moved_hit->boundary.t;
        const double bound = hit->error_bound * motion_.scale;
        if (i == 0 || result_.parted == 0) note(t, moved_t, bound, moved_hit->error_bound, i == 0);
        const double allowed = bound + bound_at(place, *moved_hit);
        const bool same = hit->object == moved_hit->object &&
                          hit->boundary.leaf == moved_hit->boundary.leaf &&
                          hit->entering == moved_hit->entering;
        const std::string what = "hit at " + hex(t) + " and at " + hex(moved_t) + ", allowed " + hex(allowed);
        if (!same || !(std::abs(moved_t - t) <= allowed)) {
            part(doubtful(place, moved_t) || doubtful(place, t), what, place);
            return;
        }
        const bool alike =
            a.children.size() == b.children.size() &&
            std::equal(a.children.begin(), a.children.end(), b.children.begin(), [&](int x, int y) {
                return here[std::size_t(x)].start().kind == there[std::size_t(y)].start().kind;
            });
        if (!alike) { // a light on the horizon, an angle that is critical
            part(true, what, place);
            return;
        }
        for (std::size_t k = 0; k < a.children.size(); ++k) follow(here, a.children[k], there, b.children[k]);
    }

    void note(double t, double moved_t, double bound, double moved_bound, bool first) {
        if (!first) return;
        result_.t = t;
        result_.moved_t = moved_t;
        result_.bound = bound;
        result_.moved_bound = moved_bound;
    }

    void part(bool allowed, const std::string& what, const Place& place) {
        ++result_.parted;
        if (!allowed) result_.wrong = what + ", ray " + hex(place.ray) + ", moved " + hex(place.moved_ray);
    }

    // World lengths, in the moved world.
    [[nodiscard]] double deviation(const Place& place, double moved_t) const {
        const Wide t = Wide(moved_t) / Wide(motion_.scale);
        Wide sum = 0;
        for (int row = 0; row < 3; ++row) {
            Wide x = Wide(motion_.matrix[3][row]);
            for (int k = 0; k < 3; ++k)
                x += Wide(motion_.matrix[k][row]) *
                     (Wide(place.ray.origin[k]) + t * Wide(place.ray.direction[k]));
            const Wide off = x - (Wide(place.moved_ray.origin[row]) +
                                  Wide(moved_t) * Wide(place.moved_ray.direction[row]));
            sum += off * off;
        }
        return double(sqrt(sum));
    }
    [[nodiscard]] double surface_deviation(std::uint32_t solid, const Place& place, double moved_t) const {
        const double size = world_.solids[solid].reach + length(place.ray.at(moved_t / motion_.scale));
        return 32 * epsilon<double> * (3 * motion_.scale * size + length(Vec3d{motion_.matrix[3]}));
    }
    [[nodiscard]] double bound_of(std::uint32_t solid, const Place& place, double moved_t, int face) const {
        return moved_.solids[solid].error_bound(place.moved_ray, moved_t, face,
                                                deviation(place, moved_t) +
                                                    surface_deviation(solid, place, moved_t));
    }
    [[nodiscard]] double bound_at(const Place& place, const BoundaryChosen& hit) const {
        return bound_of(std::uint32_t(hit.boundary.leaf), place, hit.boundary.t, hit.boundary.face);
    }

    struct Cut {
        double t, bound;
    };
    // All that any solid of the moved world has on the line, and the ray's start.
    [[nodiscard]] std::vector<Cut> cuts(const Place& place) const {
        std::vector<Cut> found{{0, 0}};
        for (std::uint32_t id = 0; id < moved_.solids.size(); ++id)
            for (const Interval<double>& span : moved_.solids[id].intervals(place.moved_ray))
                for (const auto& [t, face] :
                     {std::pair{span.enter, span.enter_face}, std::pair{span.exit, span.exit_face}})
                    if (std::isfinite(t)) found.push_back({t, bound_of(id, place, t, face)});
        std::sort(found.begin(), found.end(), [](const Cut& x, const Cut& y) { return x.t < y.t; });
        return found;
    }
    // Two of them so near to each other, and to t, that rounding may exchange or remove them. A solid that is met by one
    // ray alone shows no crossing to the other: its closest approach then is a graze of the first.
    [[nodiscard]] bool doubtful(const Place& place, double t) const {
        for (const Place& line : {place, swapped(place)}) {
            const auto list = cuts(line);
            for (std::size_t i = 0; i + 1 < list.size(); ++i) {
                const double reach = 2 * (list[i].bound + list[i + 1].bound);
                if (list[i + 1].t - list[i].t <= reach && list[i].t - reach <= t &&
                    t <= list[i + 1].t + reach)
                    return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool doubtful_line(const Place& place, double reach) const {
        for (const Place& line : {place, swapped(place)}) {
            const auto list = cuts(line);
            for (std::size_t i = 0; i < list.size(); ++i) {
                if (std::abs(list[i].t - reach) <= list[i].bound) return true;
                if (i + 1 < list.size() &&
                    list[i + 1].t - list[i].t <= 2 * (list[i].bound + list[i + 1].bound))
                    return true;
            }
        }
        return false;
    }
    // The other ray, seen in the moved world: moved, and rounded.
    [[nodiscard]] Place swapped(const Place& place) const {
        return {place.ray,
                {transformed_point(motion_.matrix, place.ray.origin),
                 transformed_vector(motion_.matrix, place.ray.direction) / motion_.scale}};
    }

    const World<double>& world_;
    const World<double>& moved_;
    Motion motion_;
    Agreement result_;
};

} // namespace rayscope::test
