#include "core/effects/used_materials.hpp"

#include "core/scene/expand.hpp"

#include <map>

namespace rayscope {

std::vector<UsedMaterial> used_materials(const Scene& scene) {
    std::map<std::size_t, UsedMaterial> found;
    const auto add = [&](const std::optional<std::size_t>& material, std::size_t object, bool is_object) {
        if (!material) return;
        const auto [at, fresh] = found.try_emplace(*material, UsedMaterial{*material, object, is_object});
        if (!fresh && is_object && !at->second.is_object) at->second = {*material, object, true};
    };
    for (std::size_t i = 0; i < scene.drawn.size(); ++i) {
        const SceneObject& drawn = scene.drawn[i];
        if (!drawn.is_compound) {
            add(scene.generics[drawn.index].material, i, true);
            continue;
        }
        add(scene.compounds[drawn.index].material, i, true);
        for (const ExpandedNode& node : expand(scene, drawn.index))
            if (node.operation == Operation::leaf) add(node.material, i, false);
    }
    std::vector<UsedMaterial> used;
    for (const auto& entry : found) used.push_back(entry.second);
    return used;
}

} // namespace rayscope
