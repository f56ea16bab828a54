#pragma once
// Numbers in which some formulas are not the tracer's own.

#include "core/math/numbers.hpp"

namespace rayscope {

/// double, stable, but for what a set of Formulas (core/substitute) puts in place of ours. Slow: each substituted formula
/// is called through a function of somebody else's.
struct Substituted {};

template <> struct numbers::Traits<Substituted> {
    using Scalar = double;
    static constexpr Method method = Method::stable;
};

} // namespace rayscope
