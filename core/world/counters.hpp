#pragma once
// What was done, counted: each thread has its own, and they are added up at the end.

#include "core/generics/generic.hpp"

#include <array>
#include <cstdint>

namespace rayscope {

struct Counters {
    std::array<std::uint64_t, 4> rays{}; ///< by RayKind
    std::array<std::uint64_t, generic_kinds>
        tests{};                    ///< solids tested, by Generic::index(), operands included
    std::uint64_t objects = 0;      ///< objects tested, a compound being one
    std::uint64_t compounds = 0;    ///< of which compounds
    std::uint64_t nodes = 0;        ///< inner nodes of a tree that were walked through
    std::uint64_t cells = 0;        ///< leaves, cells and lists that were looked into
    std::uint64_t boxes = 0;        ///< extents of single objects and of parts of compounds that were tested
    std::uint64_t boxes_missed = 0; ///< of which the ray missed: what was in them needed no test
    std::uint64_t cut_by_depth = 0, cut_by_weight = 0, cut_by_ray_limit = 0; ///< rays not followed
    std::uint64_t total_reflections = 0;

    Counters& operator+=(const Counters& other);
};

} // namespace rayscope
