#pragma once
// Where an octree stops to divide, and what came of it.

#include <cstddef>
#include <string>

namespace rayscope {

/// What is 0 is found from the scene. The lecture notes' rule, to divide down to a least volume, is
/// {.capacity = 1, .least_size = …}.
struct OctreeLimits {
    static constexpr int deepest = 24;

    int depth = 0;         ///< of the tree, at most `deepest`
    int capacity = 0;      ///< objects in a cell that is not divided any further
    double least_size = 0; ///< edge of a cell that is not divided any further, as a share of the whole
};

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
    std::size_t apart = 0;             ///< objects without end: see Unboxed
    std::size_t bytes = 0;
    double build_seconds = 0;
};

} // namespace rayscope
