#include "visualizer/window/known_part.hpp"

namespace rayscope::window {

Trace known_part(const Walk& walk) {
    Trace known = walk.trace();
    known.colour = Colour{0};
    const Timeline& timeline = walk.timeline();
    const std::size_t now = walk.cursor().moment();
    const auto started = [&](int ray) { return timeline.start(ray) <= now; };
    while (!started(int(known.rays.size()) - 1)) known.rays.pop_back();
    for (std::size_t i = 0; i < known.rays.size(); ++i) {
        TracedRay& ray = known.rays[i];
        while (ray.events.size() > 1 && timeline.moment({int(i), int(ray.events.size()) - 1}) > now)
            ray.events.pop_back();
        std::erase_if(ray.children, [&](int child) { return !started(child); });
    }
    return known;
}

bool is_finished(const TracedRay& ray) { return ray.find<RayFinished>() != nullptr; }

} // namespace rayscope::window
