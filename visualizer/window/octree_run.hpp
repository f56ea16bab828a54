#pragma once
// A trace once more by the octree, with the cells that its rays look into: made when first asked for.

#include "core/rayscope.hpp"

namespace rayscope::window {

class OctreeRun {
public:
    /// Another trace of the workbench; it must live until the next one begins.
    void begin(std::shared_ptr<const Workbench> bench, const Trace& trace);
    /// The same rays.
    [[nodiscard]] const Trace& trace();
    /// Of the whole octree.
    [[nodiscard]] const OctreeStatistics& statistics();

private:
    void build();

    std::shared_ptr<const Workbench> bench_;
    const Trace* of_ = nullptr;
    std::optional<Trace> trace_;
    std::shared_ptr<const StageSet> stages_;
    OctreeStatistics statistics_;
};

} // namespace rayscope::window
