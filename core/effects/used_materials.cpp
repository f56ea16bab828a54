#include "core/effects/used_materials.hpp"

#include "core/scene/expand.hpp"

#include <optional>

namespace rayscope {

std::vector<UsedMaterial> used_materials(const Scene& scene) {
    std::vector<std::optional<UsedMaterial>> found(scene.materials.size());
    const auto add = [&](const std::optional<std::size_t>& material, std::size_t object, bool is_object) {
        if (!material) return;
        std::optional<UsedMaterial>& used = found[*material];
        if (!used || (is_object && !used->is_object)) used = {*material, object, is_object};
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
    for (const auto& entry : found)
        if (entry) used.push_back(*entry);
    return used;
}

} // namespace rayscope
