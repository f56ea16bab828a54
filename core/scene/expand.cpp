#include "core/scene/expand.hpp"

namespace rayscope {
namespace {

// A node that is being visited: its operands first, then itself.
struct Visit {
    std::size_t compound, node;
    Mat4d matrix;                             // of the space that the compound stands in
    std::optional<std::size_t> material = {}; // of the innermost compound that has one
    int operands_done = 0;
};

} // namespace

std::vector<ExpandedNode> expand(const Scene& scene, std::size_t compound, std::size_t limit) {
    std::vector<ExpandedNode> tree;
    std::vector<std::uint32_t> roots; // of the finished operands that wait for their operation
    std::vector<Visit> open;
    const auto enter = [&](std::size_t which, const Mat4d& outer, std::optional<std::size_t> material) {
        const SceneCompound& c = scene.compounds[which];
        open.push_back({which, c.nodes.size() - 1, outer * c.matrix, c.material ? c.material : material});
    };
    enter(compound, Mat4d{1}, std::nullopt);
    while (!open.empty()) {
        Visit& visit = open.back();
        const SceneNode& node = scene.compounds[visit.compound].nodes[visit.node];
        if (node.operation == Operation::leaf && node.is_compound) { // stands for the other compound's root
            const Visit outer = visit;
            open.pop_back();
            enter(node.operand, outer.matrix, outer.material);
            continue;
        }
        const int operands =
            node.operation == Operation::leaf ? 0 : (node.operation == Operation::complement ? 1 : 2);
        if (visit.operands_done < operands) {
            const std::size_t next = visit.operands_done == 0 ? node.left : node.right;
            ++visit.operands_done;
            const Visit operand{visit.compound, next, visit.matrix, visit.material};
            open.push_back(operand);
            continue;
        }
        ExpandedNode done;
        done.operation = node.operation;
        done.compound = visit.compound;
        done.node = visit.node;
        if (operands == 0) {
            done.generic = node.operand;
            const SceneGeneric& generic = scene.generics[node.operand];
            done.matrix = visit.matrix * generic.matrix;
            done.material = generic.material ? generic.material : visit.material;
        }
        if (operands == 2) {
            done.right = roots.back();
            roots.pop_back();
        }
        if (operands >= 1) {
            done.left = roots.back();
            roots.pop_back();
        }
        if (tree.size() == limit)
            throw InputError(scene.file, scene.compounds[compound].place,
                             "with compound '" + scene.compounds[compound].name +
                                 "' written out, the scene's compounds have more than " +
                                 std::to_string(max_nodes) + " nodes");
        roots.push_back(std::uint32_t(tree.size()));
        tree.push_back(done);
        open.pop_back();
    }
    return tree;
}

} // namespace rayscope
