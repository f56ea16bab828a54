#pragma once
// The events of all rays in the order in which they happened.

#include "core/trace/trace.hpp"

#include <cstddef>

namespace rayscope {

/// One event of one ray.
struct Spot {
    int ray = 0, event = 0;
    friend bool operator==(const Spot&, const Spot&) = default;
};

/// A trace keeps the events of each ray together; in time those of the rays that it spawned lie between them. A moment
/// is a place in that order, from 0.
class Timeline {
public:
    /// @param trace of at least one ray, each with at least one event, as every recorded trace is
    explicit Timeline(const Trace& trace);

    [[nodiscard]] std::size_t size() const { return spots_.size(); }
    [[nodiscard]] Spot at(std::size_t moment) const { return spots_[moment]; }
    [[nodiscard]] std::size_t moment(Spot spot) const {
        return moments_[first_[std::size_t(spot.ray)] + std::size_t(spot.event)];
    }
    /// When a ray starts, and the last moment of it and of all that it spawned.
    [[nodiscard]] std::size_t start(int ray) const { return moment({ray, 0}); }
    [[nodiscard]] std::size_t end(int ray) const { return ends_[std::size_t(ray)]; }
    /// The rays in the order of their starts.
    [[nodiscard]] const std::vector<int>& rays() const { return rays_; }

private:
    std::vector<Spot> spots_;
    std::vector<std::size_t> moments_, first_; // first_: of a ray, in moments_
    std::vector<std::size_t> ends_;
    std::vector<int> rays_;
};

} // namespace rayscope
