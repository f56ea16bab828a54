#pragma once
// Where an octree stops to divide.

namespace rayscope {

/// What is 0 is found from the scene. The lecture notes' rule, to divide down to a least volume, is
/// {.capacity = 1, .least_size = …}.
struct OctreeLimits {
    static constexpr int deepest = 24;

    int depth = 0;         ///< of the tree, at most `deepest`
    int capacity = 0;      ///< objects in a cell that is not divided any further
    double least_size = 0; ///< edge of a cell that is not divided any further, as a share of the whole

    friend bool operator==(const OctreeLimits&, const OctreeLimits&) = default;
};

} // namespace rayscope
