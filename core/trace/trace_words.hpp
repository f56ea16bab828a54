#pragma once
// The words by which a trace's file calls the values of enumerations.

#include "core/trace/trace.hpp"

#include <string_view>

namespace rayscope {

/// The words that stand for an enumeration's values, in their order.
template <typename E> struct Words;
template <> struct Words<RayKind> {
    static constexpr std::string_view list[] = {"eye", "reflected", "refracted", "shadow"};
};
template <> struct Words<Reason> {
    static constexpr std::string_view list[] = {"coefficient_zero",          "depth",     "weight",
                                                "total_internal_reflection", "ray_limit", "leaves_solid"};
};
template <> struct Words<StageKind> {
    static constexpr std::string_view list[] = {"scan", "extents", "projective", "light", "octree", "bvh"};
};
template <> struct Words<PlaceKind> {
    static constexpr std::string_view list[] = {"extent", "tile", "light_cell", "entry",
                                                "cell",   "node", "part"};
};
template <> struct Words<SearchEnd> {
    static constexpr std::string_view list[] = {"nothing_left", "beyond_reach", "blocked", "covered"};
};
template <> struct Words<Operation> {
    static constexpr std::string_view list[] = {"leaf", "union", "intersection", "difference", "complement"};
};

/// An enumeration whose values have words.
template <typename E>
concept Worded = requires { Words<E>::list; };

} // namespace rayscope
