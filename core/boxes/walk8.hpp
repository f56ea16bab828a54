#pragma once
// The way of a ray through a tree of boxes, nearest first.

#include "core/boxes/node8.hpp"
#include "core/boxes/unwatched.hpp"

#include <bit>
#include <span>

namespace rayscope {

/// Calls leaf(number) for the leaves that the ray may meet, roughly from the nearest on, until it returns true.
/// @param nodes a tree as BoxTreeBuilder makes it, not empty
/// @param reach reach() is how far the ray still counts, in the tree's units: it may shrink on the way
/// @param visited counts the nodes
template <typename Reach, typename Leaf, typename Watch = Unwatched>
void walk8(std::span<const Node8> nodes, const Ray8& ray, const Reach& reach, std::uint64_t& visited,
           const Leaf& leaf, const Watch& watch = {}) {
    struct Ahead {
        std::uint32_t child;
        float enter;
    };
    constexpr std::size_t deepest = 64;
    std::array<Ahead, 7 * deepest + 8> stack;
    std::size_t top = 0;
    stack[top++] = {0, 0};
    while (top > 0) {
        const Ahead place = stack[--top];
        const float limit = reach();
        if (place.enter > limit) {
            watch.left_out();
            continue;
        }
        if ((place.child & Node8::leaf) != 0) {
            if (leaf(place.child & ~Node8::leaf)) return;
            continue;
        }
        ++visited;
        watch.node(place.child);
        const Node8& node = nodes[place.child];
        const Ray8::Entered entered = ray.enter(node, limit);
        // Farthest first, so that the nearest is taken next.
        const std::size_t bottom = top;
        for (unsigned left = entered.boxes; left != 0; left &= left - 1) {
            const auto i = std::size_t(std::countr_zero(left));
            std::size_t at = top++;
            for (; at > bottom && stack[at - 1].enter < entered.at[i]; --at) stack[at] = stack[at - 1];
            stack[at] = {node.child[i], entered.at[i]};
        }
    }
}

} // namespace rayscope
