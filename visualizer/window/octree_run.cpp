#include "visualizer/window/octree_run.hpp"

namespace rayscope::window {

void OctreeRun::begin(std::shared_ptr<const Workbench> bench, const Trace& trace) {
    if (bench != bench_) stages_.reset();
    bench_ = std::move(bench);
    of_ = &trace;
    trace_.reset();
}

void OctreeRun::build() {
    if (stages_ != nullptr) return;
    stages_ = make_stages(*bench_, stage_choice("octree"));
    statistics_ = octree_statistics(*stages_).value();
}

const Trace& OctreeRun::trace() {
    build();
    if (trace_) return *trace_;
    const TraceSource& source = of_->source;
    const RaySpawned& start = of_->rays.front().start();
    trace_ = source.by_hand ? trace_ray(*bench_, *stages_, {start.origin, start.direction})
                            : trace_pixel(*bench_, *stages_, source.x, source.y, 0, 0, source.sample);
    return *trace_;
}

const OctreeStatistics& OctreeRun::statistics() {
    build();
    return statistics_;
}

} // namespace rayscope::window
