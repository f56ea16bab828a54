#include "core/trace/children.hpp"

namespace rayscope {

std::vector<int> children_of(const Trace& trace, const TracedRay& ray, RayKind kind) {
    std::vector<int> list;
    for (const int child : ray.children)
        if (trace.rays[std::size_t(child)].start().kind == kind) list.push_back(child);
    return list;
}

int shadow_ray_of(const Trace& trace, const TracedRay& ray, const LightLit& lit, int likely) {
    int found = none;
    for (const int child : children_of(trace, ray, RayKind::shadow)) {
        const RaySpawned& start = trace.rays[std::size_t(child)].start();
        if (start.light != lit.light) continue;
        if (start.direction == lit.to_light) return child;
        if (child == likely || lit.samples == 1) found = child;
    }
    return found;
}

} // namespace rayscope
