#pragma once
// A compound with the named sub-expressions in it written out.

#include "core/scene/scene.hpp"

namespace rayscope {

/// A node of the whole tree, and where its author wrote it.
struct ExpandedNode {
    Operation operation = Operation::leaf;
    std::uint32_t left = 0, right = 0;  ///< nodes of the same tree
    std::size_t generic = 0;            ///< leaves: index into Scene::generics
    Mat4d matrix{1};                    ///< leaves: of the generic's object space → world
    std::size_t compound = 0, node = 0; ///< index into Scene::compounds and its nodes
};

/// More than this many nodes are refused: sub-expressions that use each other twice double at every step.
inline constexpr std::size_t max_expanded_nodes = std::size_t(1) << 22;

/// The tree in postfix order, root last. Iterative. Throws InputError if it grows too large.
[[nodiscard]] std::vector<ExpandedNode> expand(const Scene& scene, std::size_t compound);

} // namespace rayscope
