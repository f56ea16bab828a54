#pragma once
// Who listens to a tracer.

#include "core/trace/trace.hpp"

namespace rayscope {

/// Records nothing. A tracer asks `if constexpr (Recorder::enabled)` at each place where it would record, so that with
/// this one it compiles to the code it would be without recording.
struct NullRecorder {
    static constexpr bool enabled = false;
};

/// Builds the tree of rays while they are traced. Object, medium and solid ids in its events are the world's.
class TraceRecorder {
public:
    static constexpr bool enabled = true;

    /// @param max_events what comes after so many is dropped and counted
    explicit TraceRecorder(std::size_t max_events = 1'000'000) : capacity_(max_events) {}

    /// A RaySpawned opens a ray under the current one; a RayFinished closes it.
    void record(const Event& event);

    [[nodiscard]] bool full() const { return kept_ >= capacity_; }
    [[nodiscard]] std::size_t dropped() const { return dropped_; }
    [[nodiscard]] std::vector<TracedRay> take() { return std::move(rays_); }

private:
    std::size_t capacity_, kept_ = 0, dropped_ = 0;
    std::vector<TracedRay> rays_;
    std::vector<int> open_; // from the first ray to the current one; none = dropped
};

} // namespace rayscope
