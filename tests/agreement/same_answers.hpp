#pragma once
// Two stages, one ray: the answers must be the same, bit for bit.

#include "core/stage/search.hpp"
#include "tests/support/hex.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rayscope::test {

/// What a stage says of one ray.
struct Answers {
    std::vector<Hit<double>>
        nearest; ///< each with the surface that it belongs to, where that was to be asked
    bool blocked = false;
    std::vector<Blocker<double>> blockers;

    friend bool operator==(const Answers& a, const Answers& b) {
        const auto same_hit = [](const Hit<double>& x, const Hit<double>& y) {
            return x.t == y.t && x.object == y.object && x.surface == y.surface && x.entering == y.entering;
        };
        const auto same_blocker = [](const Blocker<double>& x, const Blocker<double>& y) {
            return x.t == y.t && x.object == y.object;
        };
        return std::ranges::equal(a.nearest, b.nearest, same_hit) && a.blocked == b.blocked &&
               std::ranges::equal(a.blockers, b.blockers, same_blocker);
    }
};

template <typename Stage>
[[nodiscard]] Answers answers(const World<double>& world, const Stage& stage, const Ray<double>& ray,
                              double reach, const Leaving<double>& leaving = {}) {
    static thread_local Work<double> work;
    NullRecorder recorder;
    Answers result;
    const auto nearest = stage.closest(ray, Range<double>{0}, leaving, work, recorder);
    result.nearest.assign(nearest.all().begin(), nearest.all().end());
    for (Hit<double>& hit : result.nearest)
        if (hit.crowded) hit.surface = owner(world, ray, hit, leaving.of(hit.object), work);
    std::ranges::sort(result.nearest, [](const auto& a, const auto& b) { return a.precedes(b); });
    result.blocked = stage.blocked(ray, Range<double>{0, reach}, leaving, work, recorder);
    if (!result.blocked) result.blockers = work.blockers;
    return result;
}

[[nodiscard]] inline std::string described(const Answers& a) {
    std::string text = a.blocked ? "blocked;" : "open;";
    for (const auto& hit : a.nearest) text += " object " + std::to_string(hit.object) + " at " + hex(hit.t);
    text += "; blockers";
    for (const auto& b : a.blockers) text += " " + std::to_string(b.object) + " at " + hex(b.t);
    return text;
}

} // namespace rayscope::test
