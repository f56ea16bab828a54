#include "visualizer/cli/ray_facts.hpp"

#include "visualizer/cli/page.hpp"

namespace rayscope::cli {

std::string object_name(const Trace& trace, Id object) {
    return object == none ? "nothing" : harmless(trace.objects[std::size_t(object)].name);
}

std::string generic_name_of(const Trace& trace, Id generic) {
    return generic == none ? "nothing" : harmless(trace.generics[std::size_t(generic)]);
}

std::string medium_name(const Trace& trace, Id medium) {
    return medium == none ? "unknown" : harmless(trace.media[std::size_t(medium)].name);
}

std::string light_name(const Trace& trace, Id light) {
    const std::string name = light == none ? "" : harmless(trace.lights[std::size_t(light)].name);
    return name.empty() ? "#" + std::to_string(light) : name;
}

std::string ray_name(int ray) { return "ray" + std::string(glue) + std::to_string(ray); }

Colour coefficient_of(const Trace& trace, int ray) {
    const TracedRay& traced = trace.rays[std::size_t(ray)];
    if (traced.parent == none) return Colour{1};
    const TracedRay& parent = trace.rays[std::size_t(traced.parent)];
    if (traced.start().kind == RayKind::refracted) {
        if (const auto* refracted = parent.find<Refracted>()) return refracted->coefficient;
    } else if (const auto* reflected = parent.find<Reflected>()) {
        return reflected->coefficient;
    }
    return Colour{0};
}

int shadow_ray_to(const Trace& trace, int ray, Id light) {
    for (const int child : trace.rays[std::size_t(ray)].children)
        if (trace.rays[std::size_t(child)].start().light == light) return child;
    return none;
}

} // namespace rayscope::cli
