#include "core/cases/case_scene.hpp"

namespace rayscope {
namespace {

SceneCompound compound_of(const LineCase& exact) {
    SceneCompound compound;
    compound.name = "compound";
    std::vector<std::size_t> stack;
    const auto pop = [&] {
        const std::size_t last = stack.back();
        stack.pop_back();
        return last;
    };
    for (const CaseToken& token : exact.program) {
        SceneNode node;
        node.operation = token.operation;
        if (token.operation == Operation::leaf) {
            node.operand = token.leaf;
        } else if (token.operation == Operation::complement) {
            node.left = pop();
        } else {
            node.right = pop();
            node.left = pop();
        }
        stack.push_back(compound.nodes.size());
        compound.nodes.push_back(node);
    }
    return compound;
}

} // namespace

Scene scene_of(const LineCase& exact) {
    Scene scene;
    scene.file = exact.id;
    scene.limits.max_depth = 0; // one ray, whatever its materials would send out
    scene.materials.emplace_back();
    for (std::size_t i = 0; i < exact.leaves.size(); ++i) {
        SceneGeneric generic;
        generic.name = "leaf" + std::to_string(i);
        generic.shape = exact.leaves[i].shape;
        generic.matrix = exact.leaves[i].matrix;
        generic.material = 0;
        generic.visible = !exact.is_compound;
        scene.generics.push_back(generic);
    }
    if (exact.is_compound) {
        scene.compounds.push_back(compound_of(exact));
        scene.compounds.back().material = 0;
    }
    scene.drawn.push_back({exact.is_compound, 0});
    return scene;
}

} // namespace rayscope
