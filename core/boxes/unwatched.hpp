#pragma once
// Nobody watches a walk through a tree.

namespace rayscope {

/// Who watches a walk is told of the nodes on the way, and of what is left out as too far away.
struct Unwatched {
    void node(const auto&... /*place*/) const {}
    void left_out() const {}
};

} // namespace rayscope
