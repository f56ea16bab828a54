#pragma once
// What one thread needs to look for hits.

#include "core/csg/sweep.hpp"
#include "core/world/counters.hpp"

namespace rayscope {

/// The nearest crossing of a ray.
template <Scalar T> struct Hit {
    T t = infinity<T>;
    std::uint32_t object = 0;
    Surface surface;
    bool entering = false;

    /// Least t; on a tie the object that is first in the file.
    [[nodiscard]] bool precedes(const Hit& other) const {
        return t < other.t || (t == other.t && object < other.object);
    }
};

/// The surface on which a secondary ray starts, and on which side of its object it runs.
struct LeavingSurface {
    std::uint32_t object = 0;
    Surface surface;
    bool starts_inside = false;

    /// The face, if it is one of this solid's.
    [[nodiscard]] int face_of(std::uint32_t solid) const {
        return surface.solid == solid ? surface.face : no_face;
    }
};

/// The surfaces on which a secondary ray starts: the one that was hit, and those of other media that coincide with it.
template <Scalar T> struct Leaving {
    std::array<LeavingSurface, 4> items;
    int count = 0;
    T bound = T(0); ///< how far the start may lie from the surface that was hit: world length

    void add(const LeavingSurface& surface) {
        if (count < int(items.size())) items[std::size_t(count++)] = surface;
    }
    [[nodiscard]] const LeavingSurface* of(std::uint32_t object) const {
        for (int i = 0; i < count; ++i)
            if (items[std::size_t(i)].object == object) return &items[std::size_t(i)];
        return nullptr;
    }
};

/// A boundary of a transmitting object between a point and a light.
template <Scalar T> struct Blocker {
    T t;
    std::uint32_t object;
};

template <Scalar T> struct Work {
    SpanStack<T> scratch;
    std::vector<Blocker<T>> blockers;
    Counters counters;
};

} // namespace rayscope
