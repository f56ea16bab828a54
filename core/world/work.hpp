#pragma once
// What one thread needs to look for hits.

#include "core/csg/sweep.hpp"
#include "core/generics/mesh.hpp"
#include "core/math/ray.hpp"
#include "core/world/counters.hpp"

#include <algorithm>
#include <span>
#include <utility>

namespace rayscope {

/// The nearest crossing of a ray.
template <Scalar T> struct Hit {
    T t;
    std::uint32_t object;
    Surface surface;
    bool entering;
    bool crowded; ///< operands of the compound meet nearby: whose surface it is, is to be asked (see owner)

    /// Least t; on a tie the object that is first in the file.
    [[nodiscard]] bool precedes(const Hit& other) const {
        return t < other.t || (t == other.t && object < other.object);
    }
};

/// A surface on which a secondary ray starts.
template <Scalar T> struct LeavingSurface {
    std::uint32_t object;
    Surface surface;
    bool starts_inside; ///< the side of the object on which the ray starts
    bool crosses;       ///< it leads through the surface at once: the crossing at t = 0 counts
    T bound;            ///< how far the start may lie from the surface: world length
    T beside;           ///< how far it may lie from where the surface was met: not less, at a graze much more

    /// The face, if it is one of this solid's.
    [[nodiscard]] int face_of(std::uint32_t solid) const {
        return surface.solid == solid ? surface.face : no_face;
    }
};

/// Copies the first `count`. Almost always that is one: not worth the call that a loop becomes.
template <typename Item, std::size_t size>
void copy_few(const std::array<Item, size>& from, int count, std::array<Item, size>& to) {
    if (count > 0) to[0] = from[0];
    if (count > 1) std::copy_n(from.begin() + 1, count - 1, to.begin() + 1);
}

/// All of them: the one that was hit, and those of other objects that coincide with it.
template <Scalar T> struct Leaving {
    std::array<LeavingSurface<T>, 8>
        items; // the first `count`; the rest is nothing, and not worth setting for each ray
    int count;

    Leaving() : count(0) {}
    Leaving(const Leaving& other) : count(other.count) { copy(other); }
    Leaving& operator=(const Leaving& other) {
        count = other.count;
        copy(other);
        return *this;
    }

    void add(const LeavingSurface<T>& surface) {
        if (count < int(items.size())) items[std::size_t(count++)] = surface;
    }
    [[nodiscard]] const LeavingSurface<T>* begin() const { return items.data(); }
    [[nodiscard]] const LeavingSurface<T>* end() const { return items.data() + count; }
    [[nodiscard]] const LeavingSurface<T>* of(std::uint32_t object) const {
        for (const LeavingSurface<T>& surface : *this)
            if (surface.object == object) return &surface;
        return nullptr;
    }

private:
    void copy(const Leaving& other) { copy_few(other.items, count, items); }
};

/// The nearest hit of a ray, and the hits of other objects so close to it that rounding may have chosen between them.
template <Scalar T> class Nearest {
public:
    /// What is offered is kept if it lies within `margin` of the nearest. The margin is far above the error bounds of
    /// any two crossings that coincide; who reads the list compares those.
    explicit Nearest(const Ray<T>& ray)
        : count_(0), absolute_(largest_component(absolute(ray.origin)) * sqrt(epsilon<T>)) {}
    Nearest(const Nearest& other) : count_(other.count_), absolute_(other.absolute_) {
        copy_few(other.hits_, count_, hits_);
    }
    Nearest& operator=(const Nearest&) = delete;

    void offer(const Hit<T>& hit) {
        if (count_ == 0) {
            hits_[std::size_t(count_++)] = hit;
        } else if (hit.precedes(hits_[0])) {
            const Hit<T> second = hits_[0];
            hits_[0] = hit;
            int kept = 1;
            for (int i = 1; i < count_; ++i)
                if (close(hits_[std::size_t(i)])) hits_[std::size_t(kept++)] = hits_[std::size_t(i)];
            count_ = kept;
            add_if_close(second);
        } else {
            add_if_close(hit);
        }
    }
    explicit operator bool() const { return count_ > 0; }
    /// What is offered beyond this t is not kept.
    [[nodiscard]] T reach() const { return count_ > 0 ? hits_[0].t + margin() : infinity<T>; }
    [[nodiscard]] const Hit<T>& operator*() const { return hits_[0]; }
    [[nodiscard]] std::span<const Hit<T>> all() const { return {hits_.data(), std::size_t(count_)}; }

private:
    [[nodiscard]] T margin() const {
        constexpr T relative = limits::power_of_half<T>(limits::digits<T> / 2 - 6); // about 64 √ε
        return fma(relative, magnitude(hits_[0].t), absolute_);
    }
    [[nodiscard]] bool close(const Hit<T>& hit) const { return hit.t - hits_[0].t <= margin(); }
    void add_if_close(const Hit<T>& hit) {
        if (!close(hit)) return;
        if (count_ < int(hits_.size())) {
            hits_[std::size_t(count_++)] = hit;
            return;
        }
        auto farthest = std::max_element(hits_.begin() + 1, hits_.end(),
                                         [](const Hit<T>& a, const Hit<T>& b) { return a.precedes(b); });
        if (hit.precedes(*farthest)) *farthest = hit;
    }

    std::array<Hit<T>, 8> hits_; // the first count_
    int count_;
    T absolute_;
};

/// A boundary of a transmitting object between a point and a light.
template <Scalar T> struct Blocker {
    T t;
    std::uint32_t object;
    Surface surface;
    bool entering;
};

/// Which objects the present ray was tested against: a stage may list one in several places.
class Mailbox {
public:
    /// Forgets all visits; objects have numbers below `count`.
    void open(std::size_t count) {
        if (letters_.size() != count || ++ray_ == 0) {
            letters_.assign(count, 0);
            ray_ = 1;
        }
    }
    [[nodiscard]] bool first_visit(std::uint32_t object) {
        return std::exchange(letters_[object], ray_) != ray_;
    }

private:
    std::vector<std::uint32_t> letters_; // the last ray that each object was tested with
    std::uint32_t ray_ = 0;
};

/// Where a ray crosses an operand of a compound.
template <Scalar T> struct OperandEnd {
    T t;
    std::uint32_t solid;
};

template <Scalar T> struct Work {
    SpanStack<T> scratch;
    std::vector<OperandEnd<T>> of_operands; ///< of the compound that was asked last
    std::vector<MeshCrossing<T>> of_mesh;   ///< of the mesh that was asked last
    std::vector<Blocker<T>> blockers;
    std::vector<Hit<T>> coincident;
    Mailbox mailbox;
    Counters counters;
    bool tests_parts = false; ///< extents of parts of compounds are tested before what is in them
};

} // namespace rayscope
