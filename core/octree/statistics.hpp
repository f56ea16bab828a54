#pragma once
// What came of an octree's limits.

#include "core/stage/octree_limits.hpp"

#include <cstddef>
#include <string>

namespace rayscope {

/// Why a limit is what it is, in a sentence each.
struct OctreeReasons {
    std::string depth, capacity, least_size;
};

struct OctreeStatistics {
    OctreeLimits limits; ///< those that were kept
    OctreeReasons reasons;
    int depth = 0;                     ///< of the deepest leaf
    std::size_t nodes = 0, leaves = 0; ///< divided cells; leaves that hold anything
    std::size_t entries = 0;           ///< objects in all leaves, each as often as it is listed
    std::size_t apart = 0;             ///< objects in no cell: see sort_out
    std::size_t bytes = 0;
    double build_seconds = 0;
};

} // namespace rayscope
