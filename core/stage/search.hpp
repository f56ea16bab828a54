#pragma once
// What becomes of the objects that a stage finds worth testing: the same for all stages.

#include "core/stage/ray_use.hpp"
#include "core/stage/record_object.hpp"
#include "core/world/first_of_object.hpp"

#include <algorithm>

namespace rayscope {

/// What the record of a search needs besides; nothing where nothing is recorded.
template <bool recording> class SearchNotes {
protected:
    explicit SearchNotes(const Counters& /*counters*/) {}
};
template <> class SearchNotes<true> {
public:
    /// Something that begins beyond reach() was left out.
    void leave_out() { left_out_ = true; }
    /// What had been counted when the search began.
    [[nodiscard]] const Counters& before() const { return before_; }

protected:
    explicit SearchNotes(const Counters& counters) : before_(counters) {}
    [[nodiscard]] SearchEnd end_of_way() const {
        return left_out_ ? SearchEnd::beyond_reach : SearchEnd::nothing_left;
    }

private:
    Counters before_;
    bool left_out_ = false;
};

/// The nearest crossing with t in the range, with those of other objects that may coincide with it. What it holds in the
/// end depends on the objects that were tested, not on their order.
template <Numbers N, typename Recorder> class NearestSearch : public SearchNotes<Recorder::enabled> {
public:
    using T = ScalarOf<N>;
    static constexpr bool recording = Recorder::enabled;

    NearestSearch(const World<N>& world, const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                  Work<T>& work, Recorder& recorder)
        : SearchNotes<recording>(work.counters),
          world_(world),
          ray_(ray),
          range_(range),
          leaving_(leaving),
          work_(work),
          recorder_(recorder),
          nearest_(ray),
          reach_(range.max) {
        // What the ray leaves starts with a crossing at t = 0 that no box knows of. Most rays leave it for good: asked
        // here, that spares two calls; a record tells of the test all the same.
        for (const LeavingSurface<T>& surface : leaving)
            if (recording || !left_for_good(world, ray, surface, work)) test(surface.object, &surface);
    }

    /// @return true where no other object can change the answer
    bool test(std::uint32_t object) {
        if (leaving_.of(object) == nullptr) test(object, nullptr);
        return false;
    }
    /// What begins beyond this t can't change the answer.
    [[nodiscard]] T reach() const { return reach_; }
    [[nodiscard]] bool done() const { return false; }
    [[nodiscard]] SearchEnd end() const
        requires recording
    {
        return this->end_of_way();
    }
    [[nodiscard]] const Nearest<T>& result() const { return nearest_; }
    [[nodiscard]] const Ray<T>& ray() const { return ray_; }
    [[nodiscard]] Work<T>& work() const { return work_; }
    [[nodiscard]] Recorder& recorder() const { return recorder_; }

private:
    [[gnu::noinline]] void test(std::uint32_t object, const LeavingSurface<T>* start) {
        if constexpr (Recorder::enabled)
            record_object(world_, object, ray_, range_, start, work_.tests_parts, recorder_);
        const Ball<N>* ball = start == nullptr ? world_.ball_of(object) : nullptr;
        if (ball != nullptr) {
            if (const auto first = first_of_ball(*ball, object, ray_, range_, work_)) offer(*first);
        } else if (const auto first = first_of_object(world_, object, ray_, range_, start, work_)) {
            offer(*first);
        }
    }
    void offer(const Hit<T>& hit) {
        nearest_.offer(hit);
        reach_ = minimum(range_.max, nearest_.reach());
    }

    const World<N>& world_;
    const Ray<T>& ray_;
    const Range<T>& range_;
    const Leaving<T>& leaving_;
    Work<T>& work_;
    Recorder& recorder_;
    Nearest<T> nearest_;
    T reach_;
};

/// Boundaries that coincide are crossed at once, as by every other ray (see first_in_file): one of them is kept. The
/// schoolbook keeps all.
template <Numbers N, Scalar T = ScalarOf<N>>
[[gnu::noinline]] void settle_blockers(const World<N>& world, const Ray<T>& ray,
                                       std::vector<Blocker<T>>& blockers) {
    std::sort(blockers.begin(), blockers.end(),
              [](const auto& a, const auto& b) { return a.t < b.t || (a.t == b.t && a.object < b.object); });
    if (is_textbook<N>) return;
    const auto crossing = [](const Blocker<T>& b) { return Crossing<T>{b.t, b.surface, b.entering}; };
    std::size_t kept = 0;
    for (std::size_t first = 0, next = 0; first < blockers.size(); first = next, ++kept) {
        const Blocker<T> nearest = blockers[first];
        Blocker<T> owner = nearest;
        // Up to where an object comes a second time: that is the next boundary.
        const auto is_new = [&](const Blocker<T>& other) {
            return std::none_of(blockers.begin() + std::ptrdiff_t(first),
                                blockers.begin() + std::ptrdiff_t(next),
                                [&](const Blocker<T>& known) { return known.object == other.object; });
        };
        for (next = first + 1; next < blockers.size() && is_new(blockers[next]) &&
                               coincide(world, ray, crossing(nearest), crossing(blockers[next]));
             ++next)
            if (blockers[next].object < owner.object) owner = blockers[next];
        blockers[kept] = owner;
    }
    blockers.resize(kept);
}

/// Whether an opaque object has a crossing in the range. If there is none, work.blockers holds the crossings of
/// transmitting objects in the range, by (t, object); of those that coincide, that of the object which is first in the file.
template <Numbers N, typename Recorder> class BlockerSearch : public SearchNotes<Recorder::enabled> {
public:
    using T = ScalarOf<N>;
    static constexpr bool recording = Recorder::enabled;

    BlockerSearch(const World<N>& world, const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                  Work<T>& work, Recorder& recorder)
        : SearchNotes<recording>(work.counters),
          world_(world),
          ray_(ray),
          range_(range),
          leaving_(leaving),
          work_(work),
          recorder_(recorder) {
        work.blockers.clear();
        for (const LeavingSurface<T>& surface : leaving)
            if (!blocked_ && (recording || !left_for_good(world, ray, surface, work)))
                test(surface.object, &surface);
    }

    bool test(std::uint32_t object) {
        if (leaving_.of(object) == nullptr) test(object, nullptr);
        return blocked_;
    }
    /// A stage knows that an opaque object has a crossing in the range.
    void covered() { blocked_ = covered_ = true; }
    [[nodiscard]] T reach() const { return range_.max; }
    [[nodiscard]] bool done() const { return blocked_; }
    [[nodiscard]] SearchEnd end() const
        requires recording
    {
        if (covered_) return SearchEnd::covered;
        if (blocked_) return SearchEnd::blocked;
        return this->end_of_way();
    }
    [[nodiscard]] bool result() {
        if (!blocked_ && work_.blockers.size() > 1) settle_blockers(world_, ray_, work_.blockers);
        return blocked_;
    }
    [[nodiscard]] const Ray<T>& ray() const { return ray_; }
    [[nodiscard]] Work<T>& work() const { return work_; }
    [[nodiscard]] Recorder& recorder() const { return recorder_; }

private:
    [[gnu::noinline]] void test(std::uint32_t object, const LeavingSurface<T>* start) {
        if constexpr (Recorder::enabled)
            record_object(world_, object, ray_, range_, start, work_.tests_parts, recorder_);
        const Ball<N>* ball = start == nullptr ? world_.ball_of(object) : nullptr;
        if (ball != nullptr) return test_ball(*ball, object);
        if (!world_.material_of(object).transmits()) {
            blocked_ = first_of_object(world_, object, ray_, range_, start, work_).has_value();
            return;
        }
        if (start != nullptr && left_for_good(world_, ray_, *start, work_)) return;
        const auto list = crossings(world_, object, ray_, start, work_);
        if (const auto first = first_crossing(world_, ray_, list, range_, start)) {
            work_.blockers.push_back({first->t, object, first->surface, first->entering});
            for (const Crossing<T>& c : list)
                if (c.t > first->t && range_.contains(c.t))
                    work_.blockers.push_back({c.t, object, c.surface, c.entering});
        }
    }
    // Most are missed, and their materials need not be asked for.
    void test_ball(const Ball<N>& ball, std::uint32_t object) {
        const auto first = first_of_ball(ball, object, ray_, range_, work_);
        if (!first) return;
        blocked_ = !world_.material_of(object).transmits();
        if (blocked_) return;
        work_.blockers.push_back({first->t, object, first->surface, first->entering});
        for (const Interval<T>& inside : ball.intervals(ray_))
            if (inside.exit > first->t && range_.contains(inside.exit))
                work_.blockers.push_back({inside.exit, object, ball.surface(inside.exit_face), false});
    }

    const World<N>& world_;
    const Ray<T>& ray_;
    const Range<T>& range_;
    const Leaving<T>& leaving_;
    Work<T>& work_;
    Recorder& recorder_;
    bool blocked_ = false, covered_ = false;
};

/// A stage is a type with look(use, search): it calls search.test(object) for every object that may change the answer,
/// until that returns true, and may leave out all that lie beyond search.reach(); tests_parts(use) is whether it has the
/// extents of a compound's parts tested. From it follow the two questions that
/// a tracer asks, and that every stage answers alike, bit for bit.
template <Numbers N, typename Stage> class StageBase {
public:
    using T = ScalarOf<N>;

    template <typename Recorder>
    [[nodiscard]] Nearest<T> closest(const RayUse& use, const Ray<T>& ray, const Range<T>& range,
                                     const Leaving<T>& leaving, Work<T>& work, Recorder& recorder) const {
        const auto& stage = static_cast<const Stage&>(*this);
        work.tests_parts = stage.tests_parts(use);
        NearestSearch<N, Recorder> search(world_, ray, range, leaving, work, recorder);
        stage.look(use, search);
        return search.result();
    }

    template <typename Recorder>
    [[nodiscard]] bool blocked(const RayUse& use, const Ray<T>& ray, const Range<T>& range,
                               const Leaving<T>& leaving, Work<T>& work, Recorder& recorder) const {
        const auto& stage = static_cast<const Stage&>(*this);
        work.tests_parts = stage.tests_parts(use);
        BlockerSearch<N, Recorder> search(world_, ray, range, leaving, work, recorder);
        if (!search.done()) stage.look(use, search);
        return search.result();
    }

    /// The same for a ray of no certain pixel or light.
    template <typename Recorder>
    [[nodiscard]] Nearest<T> closest(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                                     Work<T>& work, Recorder& recorder) const {
        return closest(RayUse{}, ray, range, leaving, work, recorder);
    }
    template <typename Recorder>
    [[nodiscard]] bool blocked(const Ray<T>& ray, const Range<T>& range, const Leaving<T>& leaving,
                               Work<T>& work, Recorder& recorder) const {
        return blocked(RayUse{RayKind::shadow}, ray, range, leaving, work, recorder);
    }

    [[nodiscard]] static constexpr bool tests_parts(const RayUse& /*use*/) { return true; }

protected:
    explicit StageBase(const World<N>& world) : world_(world) {}
    const World<N>& world_;
};

} // namespace rayscope
