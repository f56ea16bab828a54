#include "visualizer/window/explode.hpp"

namespace rayscope::window {

std::vector<drawing::Surface> operands_of(const Scene& scene, std::size_t drawn,
                                          const drawing::Region& region) {
    constexpr std::size_t most_nodes = 120;
    std::vector<drawing::Surface> found;
    const SceneObject& object = scene.drawn[drawn];
    if (!object.is_compound) return found;
    std::vector<ExpandedNode> nodes;
    try {
        nodes = expand(scene, object.index, most_nodes);
    } catch (const InputError&) {
        return found; // too many to be told apart
    }
    for (const ExpandedNode& node : nodes) {
        if (node.operation != Operation::leaf) continue;
        const SceneGeneric& generic = scene.generics[node.generic];
        drawing::Surface surface;
        surface.drawn = drawn;
        surface.name = generic.name;
        surface.flat = std::holds_alternative<Plane<double>>(generic.shape);
        surface.pieces = drawing::tessellate(generic.shape, node.matrix, {48, false}, region);
        found.push_back(std::move(surface));
    }
    return found;
}

} // namespace rayscope::window
