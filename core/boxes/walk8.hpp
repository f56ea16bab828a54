#pragma once
// The way of a ray through a tree of boxes, nearest first.

#include "core/boxes/node8.hpp"
#include "core/boxes/unwatched.hpp"

#include <bit>
#include <span>
#include <utility>

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
    std::array<Ahead, Node8::most_ahead> stack;
    std::size_t top = 0;
    Ahead place{0, 0};
    float limit = reach();
    for (;;) {
        bool descends = false;
        if ((place.child & Node8::leaf) != 0) {
            if (leaf(place.child & ~Node8::leaf)) return;
            limit = reach();
        } else {
            ++visited;
            watch.node(place.child);
            const Node8& node = nodes[place.child];
            const Ray8::Entered entered = ray.enter(node, limit);
            const auto ahead = [&](unsigned boxes) {
                const auto i = std::size_t(std::countr_zero(boxes));
                return Ahead{node.child[i], entered.at[i]};
            };
            unsigned left = entered.boxes;
            descends = left != 0;
            if (descends) place = ahead(left);
            // The others farthest first, so that the nearest is taken next.
            const std::size_t bottom = top;
            while ((left &= left - 1) != 0) {
                Ahead other = ahead(left);
                if (other.enter < place.enter) std::swap(other, place);
                std::size_t at = top++;
                for (; at > bottom && stack[at - 1].enter < other.enter; --at) stack[at] = stack[at - 1];
                stack[at] = other;
                if ((other.child & Node8::leaf) == 0) __builtin_prefetch(&nodes[other.child]);
            }
        }
        for (; !descends; watch.left_out()) {
            if (top == 0) return;
            place = stack[--top];
            if (place.enter <= limit) break;
        }
    }
}

} // namespace rayscope
