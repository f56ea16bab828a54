#include "visualizer/drawing/scene_objects.hpp"

#include <unordered_map>

namespace rayscope::drawing {

std::vector<Id> drawn_objects(const Trace& trace, const Scene& scene) {
    std::unordered_map<std::string, Id> by_name;
    for (const TraceObject& object : trace.objects) by_name.emplace(object.name, none);
    for (std::size_t i = 0; i < scene.drawn.size(); ++i)
        if (const auto found = by_name.find(object_title(scene, scene.drawn[i]));
            found != by_name.end() && found->second == none)
            found->second = Id(i);
    std::vector<Id> ids;
    for (const TraceObject& object : trace.objects) ids.push_back(by_name.at(object.name));
    return ids;
}

const SceneMaterial& material_of(const Scene& scene, std::size_t drawn) {
    static const SceneMaterial plain;
    const SceneObject& object = scene.drawn[drawn];
    const auto& material =
        object.is_compound ? scene.compounds[object.index].material : scene.generics[object.index].material;
    return material ? scene.materials[*material] : plain;
}

} // namespace rayscope::drawing
