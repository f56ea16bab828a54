#pragma once
// A whole image.

#include "core/image/image.hpp"
#include "core/image/map.hpp"
#include "core/math/sequence.hpp"
#include "core/octree/statistics.hpp"
#include "core/stage/stage_choice.hpp"
#include "core/trace/trace.hpp"
#include "core/tracer/heat.hpp"
#include "core/world/camera.hpp"
#include "core/world/counters.hpp"
#include "core/world/world.hpp"

#include <atomic>
#include <functional>

namespace rayscope {

struct RenderOptions {
    int width = 0, height = 0;        ///< 0: the camera's
    int samples = 0;                  ///< at most so many in a pixel; 0: the camera's
    bool even_samples = false;        ///< all of them in every pixel, whatever its neighbours are: to compare
    int threads = 0;                  ///< 0: one for each processor
    std::optional<StageChoice> stage; ///< of double stable; none: the quickest for the scene
    bool all_effects = false;         ///< by the tracer with all effects, also where the classic one would do
    std::optional<Heat> heat;         ///< also measure what each pixel costs, or who brings its light
    std::function<void(double)> progress;    ///< called with 0 … 1, by one thread at a time
    const std::atomic<bool>* stop = nullptr; ///< set to true from outside: the render ends soon, incomplete

    [[nodiscard]] bool maps_light() const { return heat && is_light(*heat); }
};

/// What a render did, and how long it took.
struct RenderStatistics {
    Counters counters;
    StageChoice stage;                        ///< that found the hits
    std::string stage_reason;                 ///< why it was chosen; empty where it was asked for
    std::optional<OctreeStatistics> octree;   ///< where one was built
    double build_seconds = 0;                 ///< of its boxes, lists and trees; part of the next two
    double cpu_seconds = 0, wall_seconds = 0; ///< of tracing alone
};

struct RenderResult {
    Image image;
    Map heat;    ///< what each pixel cost; empty unless asked for
    Map samples; ///< taken of each pixel; empty where it is one of each
    RenderStatistics statistics;
    bool complete = true;
};

/// One sample in the middle of each pixel, and more where neighbours differ (see antialiasing.hpp). The same bytes for
/// any number of threads.
template <Numbers N>
[[nodiscard]] RenderResult render(const World<N>& world, const Camera& camera, const RenderOptions& options);

/// One ray with everything that it does; object, medium and solid ids are the world's.
struct Recording {
    std::vector<TracedRay> rays;
    Colour colour{0};
    std::size_t events_dropped = 0;
};
/// @param sample of which pixel the ray is which sample; nothing for a ray given by hand
template <Numbers N>
[[nodiscard]] Recording record(const World<N>& world, const Ray<double>& ray,
                               const std::optional<SampleAddress>& sample = {});

class StageSet;
/// The same by the way of stages that are built, with the places that they look into.
[[nodiscard]] Recording record(const World<double>& world, const StageSet& stages, const Ray<double>& ray,
                               const std::optional<SampleAddress>& sample = {});

} // namespace rayscope
