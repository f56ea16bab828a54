#pragma once
// How much of a box of the world an object fills.

#include "core/generics/cover.hpp"
#include "core/world/world.hpp"

namespace rayscope {

template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Cover cover_of(const World<N>& world, std::uint32_t solid, const Box<T>& box) {
    const Solid<N>& s = world.solids[solid];
    return cover_of<N>(s.shape, s.transform.box_to_object(box));
}

/// Whether the object's surface may have a point in the box. A box within a solid has none of it: a ray that starts there
/// meets the surface elsewhere.
/// @param covers scratch
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] bool has_surface_in(const World<N>& world, const Object& object, const Box<T>& box,
                                  std::vector<Cover>& covers) {
    if (!object.is_compound) return cover_of(world, object.index, box) == Cover::partial;
    const Compound& compound = world.compounds[object.index];
    covers.clear();
    for (const CompoundNode& node : compound.nodes) {
        const auto left = [&] { return covers[node.left]; };
        const auto right = [&] { return covers[node.right]; };
        switch (node.operation) {
        case Operation::leaf: covers.push_back(cover_of(world, node.solid, box)); break;
        case Operation::complement: covers.push_back(opposite(left())); break;
        case Operation::set_union: covers.push_back(united(left(), right())); break;
        case Operation::intersection:
            covers.push_back(opposite(united(opposite(left()), opposite(right()))));
            break;
        case Operation::difference: covers.push_back(opposite(united(opposite(left()), right()))); break;
        }
    }
    return covers.back() == Cover::partial;
}

} // namespace rayscope
