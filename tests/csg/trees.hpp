#pragma once
// Random trees of operations, for tests.

#include "core/csg/program.hpp"
#include "tests/support/random.hpp"

namespace rayscope::test {

using Tree = std::vector<CompoundNode>;

enum class Grown : std::uint8_t {
    anything,
    chains, ///< ((A op B) op C) op D
    no_complements,
};

/// Appends a tree with so many leaves, numbered from next_solid on; returns its root.
inline std::uint32_t grow(Random& random, int leaves, std::uint32_t& next_solid, Tree& tree, Grown grown) {
    if (grown == Grown::anything && random.below(5) == 0) {
        const std::uint32_t operand = grow(random, leaves, next_solid, tree, grown);
        tree.push_back({Operation::complement, operand, 0, 0});
    } else if (leaves == 1) {
        tree.push_back({Operation::leaf, 0, 0, next_solid++});
    } else {
        const int left = grown == Grown::chains ? leaves - 1 : 1 + random.below(leaves - 1);
        const std::uint32_t a = grow(random, left, next_solid, tree, grown);
        const std::uint32_t b = grow(random, leaves - left, next_solid, tree, grown);
        tree.push_back({Operation(1 + random.below(3)), a, b, 0});
    }
    return std::uint32_t(tree.size() - 1);
}

} // namespace rayscope::test
