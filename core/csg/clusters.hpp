#pragma once
// Coincident surfaces: where rounding would leave slivers and cracks, crossings are merged, once, at the root.

#include "core/csg/sweep.hpp"

#include <span>

namespace rayscope {

/// What merge_clusters did, for whoever records it.
template <Scalar T> struct Cluster {
    int count;
    T first, last;
    bool kept;
};

/// Merges crossings whose neighbours lie within the sum of their error bounds: an odd cluster keeps one crossing, an
/// even one vanishes, thin pieces and thin gaps alike. It acts on the root's list alone; dropping thin pieces at each
/// node would depend on how the tree is grouped.
/// @param list ascending, entering and leaving in turn, not empty
/// @param coincide called as coincide(crossing, next): may their difference in t be rounding?
/// @param merged called with each Cluster of more than one crossing
/// @return the new size of the list
template <Scalar T, typename Coincide, typename Merged>
[[nodiscard]] std::size_t merge_clusters(std::span<Crossing<T>> list, const Coincide& coincide,
                                         const Merged& merged) {
    std::size_t kept = 0;
    for (std::size_t first = 0; first < list.size();) {
        std::size_t last = first;
        while (last + 1 < list.size() && coincide(list[last], list[last + 1])) ++last;
        const std::size_t count = last - first + 1;
        if (count > 1) merged(Cluster<T>{int(count), list[first].t, list[last].t, count % 2 == 1});
        if (count % 2 == 1) {
            // All odd ones run the cluster's way; the leftmost operand's surface stands for them.
            std::size_t chosen = first;
            for (std::size_t i = first + 2; i <= last; i += 2)
                if (list[i].surface.solid < list[chosen].surface.solid) chosen = i;
            list[kept++] = list[chosen];
        }
        first = last + 1;
    }
    return kept;
}

} // namespace rayscope
