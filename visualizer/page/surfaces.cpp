#include "visualizer/page/surfaces.hpp"

#include "visualizer/page/clip.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace rayscope::page {
namespace {

bool is_plane(const Scene& scene, const SceneObject& object) {
    return !object.is_compound && std::holds_alternative<Plane<double>>(scene.generics[object.index].shape);
}

/// Names of the objects that rays end on, or are stopped by.
std::set<std::string_view> touched_names(const Trace& trace) {
    std::set<std::string_view> names;
    for (const TracedRay& ray : trace.rays)
        for (const Event& event : ray.events) {
            if (const auto* hit = std::get_if<BoundaryChosen>(&event))
                names.insert(trace.objects[std::size_t(hit->object)].name);
            if (const auto* accepted = std::get_if<ObjectAccepted>(&event);
                accepted != nullptr && ray.start().kind == RayKind::shadow)
                names.insert(trace.objects[std::size_t(accepted->object)].name);
        }
    return names;
}

/// The heavier a ray, the farther the picture reaches for its hit.
Ball shown_ball(const Workbench& bench, const Trace& trace, const std::set<std::string_view>& touched) {
    Box<double> box;
    const auto diagonal = [&] { return length(box.high - box.low); };
    const Vec3d start = trace.rays.front().start().origin;
    const auto* first = trace.rays.front().find<BoundaryChosen>();
    const double travelled = first != nullptr ? length(first->point - start) : 0;
    if (first != nullptr) box.include(first->point);
    for (std::size_t i = 0; i < bench.scene.drawn.size(); ++i) {
        const Box<double>& bounds = bench.world.objects[i].bounds;
        const bool counts =
            touched.empty() || touched.contains(object_title(bench.scene, bench.scene.drawn[i]));
        if (!bounds.bounded() || !counts) continue;
        const double size = length(bounds.high - bounds.low);
        if (travelled > 0 && size > 8 * travelled) continue;
        box = united(box, bounds);
    }
    const double reach = std::max(diagonal(), travelled / 2);
    for (const TracedRay& ray : trace.rays)
        if (const auto* hit = ray.find<BoundaryChosen>();
            hit != nullptr && weight(ray) > 0.02 && length(hit->point - box.low) < 3 * reach)
            box.include(hit->point);
    if (box.low.x > box.high.x) return {start, std::max(1.0, length(start) / 4)};
    const double radius = std::max(diagonal() / 2, travelled / 15);
    return {(box.low + box.high) / 2.0, radius > 0 && std::isfinite(radius) ? radius : 1};
}

double round_size(double size) {
    const double power = std::pow(10, std::floor(std::log10(size)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (size <= factor * power) return factor * power;
    return 10 * power;
}

Colour shown_colour(const SceneMaterial& material) {
    const auto bytes = srgb_bytes(material.diffuse + 0.5 * material.ambient);
    Colour colour{bytes[0] / 255.0, bytes[1] / 255.0, bytes[2] / 255.0};
    if (largest_component(colour) < 0.25)
        colour = {0.55, 0.62, 0.7}; // mirrors and glass are black by themselves
    return colour;
}

class Builder {
public:
    Builder(const Workbench& bench, const Ball& shown) : scene_(bench.scene), shown_(shown) {
        for (const SceneObject& object : scene_.drawn)
            if (is_plane(scene_, object))
                planes_.push_back({&object, Transform<double>(scene_.generics[object.index].matrix)});
    }

    [[nodiscard]] Surface build(const SceneObject& object, int around) const {
        Surface surface;
        surface.name = object_title(scene_, object);
        const auto material = object.is_compound ? scene_.compounds[object.index].material
                                                 : scene_.generics[object.index].material;
        if (material) {
            surface.colour = shown_colour(scene_.materials[*material]);
            surface.clear = largest_component(scene_.materials[*material].transmission) > 0;
        }
        if (object.is_compound) {
            surface.triangles = compound_surface(scene_, object.index, around, shown_);
            return surface;
        }
        const SceneGeneric& generic = scene_.generics[object.index];
        surface.triangles = tessellate(generic.shape, generic.matrix, around, false, shown_);
        if (is_plane(scene_, object)) make_flat(surface, object, generic.matrix);
        return surface;
    }

private:
    /// Walls end where they meet other walls.
    void make_flat(Surface& surface, const SceneObject& object, const Mat4d& matrix) const {
        surface.flat = true;
        const double cell = round_size(shown_.radius / 4);
        surface.u = Vec3d(matrix[0]) / length(Vec3d(matrix[0])) * cell;
        surface.v = Vec3d(matrix[1]) / length(Vec3d(matrix[1])) * cell;
        constexpr std::size_t most = 24;
        if (planes_.size() > most) return;
        for (const auto& [other, transform] : planes_)
            if (other != &object)
                surface.triangles = clipped(surface.triangles, [&](const Vec3d& p) {
                    return -transform.point_to_object(p).z - 1e-9 * shown_.radius;
                });
    }

    const Scene& scene_;
    Ball shown_;
    std::vector<std::pair<const SceneObject*, Transform<double>>> planes_;
};

} // namespace

std::size_t written_size(const Surface& surface) {
    return surface.triangles.corners.size() * 8 + surface.triangles.triangles.size() * 8 + 200;
}

Surroundings surroundings_of(const Workbench& bench, const Trace& trace, std::size_t room) {
    const auto touched = touched_names(trace);
    Surroundings result;
    result.shown = shown_ball(bench, trace, touched);
    struct Candidate {
        const SceneObject* object;
        bool hit;
        double distance;
    };
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < bench.scene.drawn.size(); ++i) {
        const SceneObject& object = bench.scene.drawn[i];
        const Box<double>& bounds = bench.world.objects[i].bounds;
        const bool hit = touched.contains(object_title(bench.scene, object));
        const double away =
            bounds.bounded() ? length((bounds.low + bounds.high) / 2.0 - result.shown.centre) : 0;
        if (hit || away < 2 * result.shown.radius) candidates.push_back({&object, hit, away});
    }
    std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
        if (a.hit != b.hit) return a.hit;
        return a.distance != b.distance ? a.distance < b.distance : a.object < b.object; // of one list
    });
    constexpr std::size_t most = 300;
    if (candidates.size() > most) {
        result.left_out = candidates.size() - most;
        candidates.resize(most);
    }
    const Builder builder(bench, result.shown);
    const auto fits = [&](int around, std::size_t objects) {
        std::size_t size = 0;
        result.surfaces.clear();
        for (std::size_t i = 0; i < objects && size <= room; ++i) {
            result.surfaces.push_back(builder.build(*candidates[i].object, around));
            size += written_size(result.surfaces.back());
        }
        return size <= room;
    };
    std::size_t objects = candidates.size();
    for (const int around : {64, 48, 32, 24, 16, 12})
        if (fits(around, objects)) return result;
    while (objects > 0 && !fits(12, objects)) {
        objects /= 2;
        result.left_out = candidates.size() - objects;
    }
    return result;
}

} // namespace rayscope::page
