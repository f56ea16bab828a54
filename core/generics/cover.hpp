#pragma once
// How much of a box a generic fills: what tells an octree where a surface is.

#include "core/generics/generic.hpp"

namespace rayscope {

enum class Cover : std::uint8_t {
    empty,   ///< the solid has no point in the box
    partial, ///< neither can be said
    full,    ///< the box has no point outside of it
};

[[nodiscard]] inline Cover opposite(Cover a) {
    return a == Cover::empty ? Cover::full : a == Cover::full ? Cover::empty : Cover::partial;
}
/// Of the union of two solids.
[[nodiscard]] inline Cover united(Cover a, Cover b) {
    if (a == Cover::full || b == Cover::full) return Cover::full;
    return a == Cover::empty && b == Cover::empty ? Cover::empty : Cover::partial;
}

namespace cover {

/// The least and the largest size of a number of an interval.
template <Scalar T> struct Sizes {
    T least, most;
    Sizes(T low, T high)
        : least(maximum(T(0), maximum(low, -high))), most(maximum(magnitude(low), magnitude(high))) {}
};
template <Scalar T> [[nodiscard]] Sizes<T> along(const Box<T>& box, int axis) {
    return {box.low[axis], box.high[axis]};
}
/// x² + y², at least and at most.
template <Scalar T> [[nodiscard]] Sizes<T> ring(const Box<T>& box) {
    const auto x = along(box, 0), y = along(box, 1);
    Sizes<T> squared(T(0), T(0));
    squared.least = fma(x.least, x.least, y.least * y.least);
    squared.most = fma(x.most, x.most, y.most * y.most);
    return squared;
}

/// Where `most` and `least` bound something that is below `limit` in the solid.
template <Scalar T> [[nodiscard]] Cover below(const Sizes<T>& sizes, T limit) {
    constexpr T rounding = T(16) * epsilon<T>;
    if (sizes.least > limit * (T(1) + rounding)) return Cover::empty;
    return sizes.most < limit * (T(1) - rounding) ? Cover::full : Cover::partial;
}
[[nodiscard]] inline Cover shared(Cover a, Cover b) { return opposite(united(opposite(a), opposite(b))); }

template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Sphere<N>& s, const Box<T>& box) {
    Sizes<T> squared = ring(box);
    const auto z = along(box, 2);
    squared.least = fma(z.least, z.least, squared.least);
    squared.most = fma(z.most, z.most, squared.most);
    return below(squared, s.radius * s.radius);
}
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Plane<N>&, const Box<T>& box) {
    if (box.low.z > T(0)) return Cover::empty;
    return box.high.z < T(0) ? Cover::full : Cover::partial;
}
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Cylinder<N>&, const Box<T>& box) {
    return shared(below(ring(box), T(1)), below(along(box, 2), T(1)));
}
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Cone<N>& c, const Box<T>& box) {
    const ConeWall<T> wall(c.top);
    const T widest = wall.radius(maximum(box.low.z, T(-1))),
            narrowest = wall.radius(minimum(box.high.z, T(1)));
    const auto squared = ring(box);
    constexpr T rounding = T(16) * epsilon<T>;
    Cover round = Cover::partial;
    if (squared.least > widest * widest + rounding) round = Cover::empty;
    if (squared.most < narrowest * narrowest - rounding) round = Cover::full;
    return shared(round, below(along(box, 2), T(1)));
}
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Cube<N>&, const Box<T>& box) {
    Cover cover = Cover::full;
    for (int axis = 0; axis < 3; ++axis) cover = shared(cover, below(along(box, axis), T(1)));
    return cover;
}
/// The distance from the core circle: ρ − 1 across, z along the axis.
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Torus<N>& t, const Box<T>& box) {
    const auto squared = ring(box), z = along(box, 2);
    const Sizes<T> across(sqrt(squared.least) - T(1), sqrt(squared.most) - T(1));
    Sizes<T> distance(T(0), T(0));
    distance.least = fma(across.least, across.least, z.least * z.least);
    distance.most = fma(across.most, across.most, z.most * z.most);
    constexpr T rounding = T(16) * epsilon<T>; // ρ itself is rounded
    if (distance.least > t.minor * t.minor + rounding) return Cover::empty;
    return distance.most < t.minor * t.minor - rounding ? Cover::full : Cover::partial;
}
/// Surfaces fill nothing.
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Polygon<N>& p, const Box<T>& box) {
    if (!p.bounds().overlaps(box)) return Cover::empty;
    const Vec3<T> n = p.normal({}, 0), middle = (box.low + box.high) / T(2),
                  half = (box.high - box.low) / T(2);
    const T distance = magnitude(dot(n, middle - p.vertices().front()));
    const Vec3<T> size = absolute(middle) + absolute(p.vertices().front());
    const T reach = dot(absolute(n), half) + T(16) * epsilon<T> * dot(absolute(n), size);
    return distance > reach ? Cover::empty : Cover::partial;
}
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Cover of(const OpenCylinder<N>&, const Box<T>& box) {
    if (of(Cylinder<N>{}, box) == Cover::empty || below(ring(box), T(1)) == Cover::full) return Cover::empty;
    return Cover::partial;
}
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const OpenCone<N>& c, const Box<T>& box) {
    return of(Cone<N>{c.top}, box) == Cover::partial ? Cover::partial : Cover::empty;
}
/// Where no triangle is, all of the box is what its middle is.
template <Numbers N, Scalar T = ScalarOf<N>> [[nodiscard]] Cover of(const Mesh<N>& m, const Box<T>& box) {
    if (!m.bounds().overlaps(box)) return Cover::empty;
    if (m.triangles().any_in(as<double>(box))) return Cover::partial;
    return m.contains((box.low + box.high) / T(2)) ? Cover::full : Cover::empty;
}

} // namespace cover

/// @param box in object space, bounded; already widened by what rounding may have moved it
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] Cover cover_of(const Generic<N>& shape, const Box<T>& box) {
    return std::visit([&](const auto& s) { return cover::of(s, box); }, shape);
}

} // namespace rayscope
