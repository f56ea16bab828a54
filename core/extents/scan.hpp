#pragma once
// The first stage: every ray against every object. What all later stages must agree with, bit for bit.

#include "core/extents/ball_blocks.hpp"
#include "core/extents/record_object.hpp"

#include <algorithm>

namespace rayscope {

template <Numbers N> class Scan {
public:
    using T = ScalarOf<N>;

    explicit Scan(const World<N>& world);

    /// The nearest crossing with t in the range, with those of other objects that may coincide with it.
    template <typename Recorder>
    [[nodiscard]] Nearest<T> closest(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                                     Work<T>& work, Recorder& recorder) const;

    /// True as soon as an opaque object has a crossing in the range. If there is none, work.blockers holds the
    /// crossings of transmitting objects in the range, by (t, object).
    template <typename Recorder>
    [[nodiscard]] bool blocked(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                               Work<T>& work, Recorder& recorder) const;

private:
    // Calls test(object, leaving surface or nullptr) for every object that may be hit, until it returns true.
    template <typename Recorder, typename Test>
    void each_candidate(const Ray<T>& ray, const Leaving<T>& leaving, Work<T>& work, const Test& test) const;

    const World<N>& world_;
    BallBlocks<N> balls_;
    std::vector<std::uint32_t> others_; // objects that no ball decides on, in the order of the file
    std::vector<std::uint32_t>
        not_balls_; // with the compounds that one decides on: a recorded ray tells of them too
};

template <Numbers N> Scan<N>::Scan(const World<N>& world) : world_(world), balls_(world) {
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (!world.is_ball(object)) not_balls_.push_back(id);
        if (!deciding_ball(world, object)) others_.push_back(id);
    }
}

template <Numbers N>
template <typename Recorder, typename Test>
void Scan<N>::each_candidate(const Ray<T>& ray, const Leaving<T>& leaving, Work<T>& work,
                             const Test& test) const {
    // What the ray leaves starts with a crossing at t = 0 that the blocks know nothing of.
    for (const LeavingSurface<T>& surface : leaving)
        if (test(surface.object, &surface)) return;
    const auto untested = [&](std::uint32_t object) { return leaving.of(object) == nullptr; };
    bool done = false;
    std::size_t met = 0, later = Recorder::enabled ? not_balls_.size() - others_.size() : 0;
    const std::size_t balls = balls_.each_met(ray, [&](std::uint32_t object) {
        ++met; // counted by its test
        if (Recorder::enabled && world_.objects[object].is_compound) {
            --later;
            return false; // its turn comes below
        }
        return done = untested(object) && test(object, nullptr);
    });
    const std::size_t unmet = balls - met - std::min(balls - met, later);
    work.counters.objects += unmet;
    work.counters.tests[Generic<N>(Sphere<N>{}).index()] += unmet;
    const std::vector<std::uint32_t>& rest = Recorder::enabled ? not_balls_ : others_;
    for (std::size_t i = 0; i < rest.size() && !done; ++i) done = untested(rest[i]) && test(rest[i], nullptr);
}

template <Numbers N>
template <typename Recorder>
auto Scan<N>::closest(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving, Work<T>& work,
                      Recorder& recorder) const -> Nearest<T> {
    Nearest<T> nearest(ray);
    each_candidate<Recorder>(ray, leaving, work, [&](std::uint32_t object, const LeavingSurface<T>* start) {
        if constexpr (Recorder::enabled) record_object(world_, object, ray, range, start, recorder);
        if (const auto first = first_of_object(world_, object, ray, range, start, work))
            nearest.offer(*first);
        return false;
    });
    return nearest;
}

template <Numbers N>
template <typename Recorder>
bool Scan<N>::blocked(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving, Work<T>& work,
                      Recorder& recorder) const {
    bool found = false;
    work.blockers.clear();
    each_candidate<Recorder>(ray, leaving, work, [&](std::uint32_t object, const LeavingSurface<T>* start) {
        if constexpr (Recorder::enabled) record_object(world_, object, ray, range, start, recorder);
        if (!world_.material_of(object).transmits())
            return found = first_of_object(world_, object, ray, range, start, work).has_value();
        const auto list = crossings(world_, object, ray, start, work);
        if (const auto first = first_crossing(world_, ray, list, range, start)) {
            work.blockers.push_back({first->t, object});
            for (const Crossing<T>& c : list)
                if (c.t > first->t && range.contains(c.t)) work.blockers.push_back({c.t, object});
        }
        return false;
    });
    if (found) return true;
    std::sort(work.blockers.begin(), work.blockers.end(), [](const Blocker<T>& a, const Blocker<T>& b) {
        return a.t < b.t || (a.t == b.t && a.object < b.object);
    });
    return false;
}

} // namespace rayscope
