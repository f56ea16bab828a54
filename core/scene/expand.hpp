#pragma once
// A compound with the named sub-expressions in it written out.

#include "core/scene/scene.hpp"

namespace rayscope {

/// A node of the whole tree, and where its author wrote it.
struct ExpandedNode {
    Operation operation = Operation::leaf;
    std::uint32_t left = 0, right = 0; ///< nodes of the same tree
    std::size_t generic = 0;           ///< leaves: index into Scene::generics
    Mat4d matrix{1};                   ///< leaves: of the generic's object space → world
    std::optional<std::size_t>
        material; ///< leaves: the generic's own, else the innermost named compound's, if any
    std::size_t compound = 0, node = 0; ///< index into Scene::compounds and its nodes
};

/// A scene's compounds may have this many nodes in all: sub-expressions that use each other twice double at every step.
inline constexpr std::size_t max_nodes = std::size_t(1) << 22;

/// The tree in postfix order, root last. Iterative. Throws InputError if it has more than `limit` nodes.
[[nodiscard]] std::vector<ExpandedNode> expand(const Scene& scene, std::size_t compound,
                                               std::size_t limit = max_nodes);

} // namespace rayscope
