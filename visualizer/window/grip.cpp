#include "visualizer/window/grip.hpp"

#include "visualizer/drawing/scene_objects.hpp"

#include <glm/matrix.hpp>

namespace rayscope::window {
namespace {

constexpr std::size_t most_operands = 400;

Mat4d matrix_of(const Scene& scene, const Grip& grip) {
    return grip.outer * scene.generics[grip.generic].matrix;
}

Grip grip_of(const Scene& scene, const ExpandedNode& leaf) {
    return {leaf.generic, leaf.matrix * glm::inverse(scene.generics[leaf.generic].matrix)};
}

} // namespace

Vec3d middle_of(const Scene& scene, const Grip& grip) {
    const auto bounds =
        std::visit([](const auto& shape) { return shape.bounds(); }, scene.generics[grip.generic].shape);
    const Vec3d middle = bounds.bounded() ? (bounds.low + bounds.high) / 2.0 : Vec3d{0};
    return Vec3d(matrix_of(scene, grip) * glm::dvec4(middle, 1));
}

Vec3d offset_to(const Scene& scene, const Grip& grip, const Vec3d& middle) {
    return Transform<double>(grip.outer).vector_to_object(middle - middle_of(scene, grip));
}

std::vector<Grip> grips_of(const Scene& scene, std::size_t drawn) {
    const SceneObject& object = scene.drawn[drawn];
    if (!object.is_compound) return {{object.index, Mat4d{1}}};
    std::vector<Grip> grips;
    try {
        for (const ExpandedNode& node : expand(scene, object.index, 2 * most_operands))
            if (node.operation == Operation::leaf) grips.push_back(grip_of(scene, node));
    } catch (const InputError&) { // its way to say that there are more
        return {};
    }
    return grips;
}

std::optional<Grip> grip_at(const Workbench& bench, Ray<double> ray,
                            const std::function<bool(std::size_t drawn, bool entering)>& seen) {
    constexpr int most_layers = 64;
    for (int layer = 0; layer < most_layers; ++layer) {
        const Trace trace = trace_ray(bench, ray);
        const auto* hit = trace.rays.front().find<BoundaryChosen>();
        if (hit == nullptr) return std::nullopt;
        const auto drawn = std::size_t(drawing::drawn_objects(trace, bench.scene)[std::size_t(hit->object)]);
        if (!seen(drawn, hit->entering)) {
            ray.origin = ray.at(hit->boundary.t + 2 * hit->error_bound + 1e-9 * hit->boundary.t);
            continue;
        }
        const SceneObject& object = bench.scene.drawn[drawn];
        if (!object.is_compound) return Grip{object.index, Mat4d{1}};
        // The trace has the nodes of an object in the order of its expansion.
        const auto& nodes = trace.objects[std::size_t(hit->object)].nodes;
        const auto expanded = expand(bench.scene, object.index);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (nodes[i].generic == hit->boundary.leaf && hit->boundary.leaf != none)
                return grip_of(bench.scene, expanded[i]);
        return std::nullopt;
    }
    return std::nullopt;
}

} // namespace rayscope::window
