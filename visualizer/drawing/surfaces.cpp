#include "visualizer/drawing/surfaces.hpp"

#include "visualizer/drawing/ray_path.hpp"
#include "visualizer/drawing/scene_objects.hpp"

#include <algorithm>
#include <set>

namespace rayscope::drawing {
namespace {

// More of them hide the rays; and without a graphics card, their triangles take a hundred megabytes.
constexpr std::size_t most_objects = 100;
constexpr std::size_t most_ways = 64;

/// Which of the objects rays hit, or are stopped by.
std::set<Id> touched_objects(const Trace& trace, const std::vector<Id>& drawn) {
    std::set<Id> touched;
    const auto touch = [&](Id object) {
        if (object >= 0 && std::size_t(object) < drawn.size() && drawn[std::size_t(object)] != none)
            touched.insert(drawn[std::size_t(object)]);
    };
    for (const TracedRay& ray : trace.rays) {
        if (const auto* hit = ray.find<BoundaryChosen>()) touch(hit->object);
        if (!is_blocked(ray)) continue;
        for (const Event& event : ray.events)
            if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) touch(accepted->object);
    }
    return touched;
}

double distance(const Box<double>& box, const Vec3d& p) {
    Vec3d outside{0};
    for (int i = 0; i < 3; ++i) outside[i] = std::max({box.low[i] - p[i], 0.0, p[i] - box.high[i]});
    return length(outside);
}

/// How far objects are from the ways that rays take.
class Ways {
public:
    Ways(const Trace& trace, const Region& region) {
        for (const TracedRay& ray : trace.rays) {
            if (ways_.size() == most_ways) break;
            const Vec3d from = ray.start().origin;
            ways_.push_back({from, drawn_end(ray, region.open_length()).point - from});
        }
    }
    /// @param box bounded; it counts as the ball around it
    [[nodiscard]] double distance_to(const Box<double>& box) const {
        const Vec3d middle = (box.low + box.high) / 2.0;
        double nearest = infinity<double>;
        for (const Ray<double>& way : ways_) {
            const Vec3d to_middle = middle - way.origin;
            const double along = dot(to_middle, way.direction), size = dot(way.direction, way.direction);
            const double t = size > 0 ? std::clamp(along / size, 0.0, 1.0) : 0;
            nearest = std::min(nearest, length(to_middle - t * way.direction));
        }
        return std::max(0.0, nearest - length(box.high - middle));
    }

private:
    std::vector<Ray<double>> ways_; // for t from 0 to 1
};

bool is_plane(const Scene& scene, std::size_t drawn) {
    const SceneObject& object = scene.drawn[drawn];
    return !object.is_compound && std::holds_alternative<Plane<double>>(scene.generics[object.index].shape);
}

/// Distance of a half space's boundary from the region's middle.
double plane_distance(const Scene& scene, std::size_t drawn, const Region& region) {
    const Mat4d& matrix = scene.generics[scene.drawn[drawn].index].matrix;
    const Vec3d normal = Transform<double>(matrix).normal_to_world({0, 0, 1});
    return std::abs(dot(region.centre - Vec3d(matrix[3]), normal));
}

bool encloses(const Box<double>& box, const Vec3d& p) {
    for (int i = 0; i < 3; ++i)
        if (!(box.low[i] < p[i] && p[i] < box.high[i])) return false;
    return true;
}

/// Walls end where they meet other walls: what lies inside another half space can't be seen.
void cut_walls(Surfaces& surfaces, const Scene& scene) {
    std::vector<std::pair<std::size_t, Transform<double>>> planes;
    for (const Surface& surface : surfaces.shown)
        if (surface.flat)
            planes.emplace_back(surface.drawn, scene.generics[scene.drawn[surface.drawn].index].matrix);
    if (planes.size() < 2 || planes.size() > 24) return;
    for (Surface& surface : surfaces.shown) {
        if (!surface.flat) continue;
        for (const auto& [other, transform] : planes) {
            if (other == surface.drawn) continue;
            Pieces kept;
            for (const auto& piece : surface.pieces) {
                std::vector<double> values;
                for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
                    values.push_back(-transform.point_to_object(point_of(piece, i)).z);
                if (auto rest = kept_below_zero(piece, values)) kept.push_back(rest);
            }
            surface.pieces = std::move(kept);
        }
    }
}

} // namespace

Surfaces surfaces_near(const Workbench& bench, const Trace& trace, const std::vector<Id>& drawn,
                       const Region& region) {
    const Scene& scene = bench.scene;
    const std::set<Id> touched = touched_objects(trace, drawn);
    struct Candidate {
        std::size_t drawn;
        bool hit;
        double distance;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < scene.drawn.size(); ++i) {
        const bool hit = touched.contains(Id(i));
        const double away = is_plane(scene, i) ? plane_distance(scene, i, region)
                                               : distance(bench.world.objects[i].bounds, region.centre);
        if (hit || away < (is_plane(scene, i) ? 3.0 : 1.6) * region.radius)
            candidates.push_back({i, hit, away});
    }
    Surfaces surfaces;
    const bool too_many = candidates.size() > most_objects;
    if (too_many) {
        const Ways ways(trace, region);
        for (Candidate& candidate : candidates) {
            const Box<double>& bounds = bench.world.objects[candidate.drawn].bounds;
            if (bounds.bounded()) candidate.distance = ways.distance_to(bounds);
        }
    }
    std::ranges::stable_sort(candidates, [](const Candidate& a, const Candidate& b) {
        return a.hit != b.hit ? a.hit : a.distance < b.distance;
    });
    if (too_many) {
        surfaces.left_out = candidates.size() - most_objects;
        candidates.resize(most_objects);
    }
    const auto hits = std::ranges::count_if(candidates, &Candidate::hit);
    for (const Candidate& candidate : candidates) {
        const int around = candidate.hit ? (hits <= 16 ? 96 : 40) : (candidates.size() <= 40 ? 48 : 24);
        Surface surface{candidate.drawn,
                        object_title(scene, scene.drawn[candidate.drawn]),
                        candidate.hit,
                        false,
                        is_plane(scene, candidate.drawn),
                        false,
                        {}};
        const Box<double>& bounds = bench.world.objects[candidate.drawn].bounds;
        surface.large = !surface.flat && length(bounds.high - bounds.low) > 8 * region.radius;
        surface.room = bounds.bounded() && encloses(bounds, region.centre) && !trace.rays.empty() &&
                       encloses(bounds, trace.rays.front().start().origin);
        surface.pieces = object_surface(scene, candidate.drawn, {around, false}, region);
        surfaces.shown.push_back(std::move(surface));
    }
    cut_walls(surfaces, scene);
    return surfaces;
}

} // namespace rayscope::drawing
