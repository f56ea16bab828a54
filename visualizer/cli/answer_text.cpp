#include "visualizer/cli/answer_text.hpp"

#include "visualizer/cli/ray_facts.hpp"

namespace rayscope::cli {
namespace {

std::string node_text(const Trace& first, const Trace& second, const Difference& difference) {
    const std::string name = harmless(difference.object);
    for (const Trace* trace : {&first, &second})
        for (const TraceObject& object : trace->objects) {
            if (object.name != difference.object || object.nodes.size() == 1) continue;
            const auto node = std::size_t(difference.node);
            if (node + 1 < object.nodes.size())
                return harmless(object.nodes[node].name) + ", a part of " + name;
        }
    return name;
}

std::string hit_text(const Trace& trace, const TracedRay& ray, const Numbers& number) {
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return "misses everything";
    const std::string object = object_name(trace, hit->object);
    const std::string leaf = generic_name_of(trace, hit->boundary.leaf);
    return (hit->entering ? "enters " : "leaves ") + object + (leaf == object ? "" : " through " + leaf) +
           ", face " + std::to_string(hit->boundary.face) + ", at t = " + number(hit->boundary.t);
}

std::string media_text(const Trace& trace, const TracedRay& ray) {
    const auto* hit = ray.find<BoundaryChosen>();
    const std::string in = "travels in " + medium_name(trace, ray.start().medium);
    if (hit == nullptr || hit->medium_from == hit->medium_to) return in;
    return in + "; at its hit from " + medium_name(trace, hit->medium_from) + " to " +
           medium_name(trace, hit->medium_to);
}

const char* refusal_text(Reason reason) {
    switch (reason) {
    case Reason::coefficient_zero: return "not followed: the material's coefficient is 0";
    case Reason::depth: return "not followed: max_depth is reached";
    case Reason::weight: return "not followed: its weight would be below min_weight";
    case Reason::total_internal_reflection: return "not followed: total internal reflection";
    case Reason::ray_limit: return "not followed: max_rays is spent";
    case Reason::leaves_solid: break;
    }
    return "not followed";
}

std::string follow_text(const TracedRay& ray, RayKind kind, const Numbers& number) {
    for (const Event& event : ray.events)
        if (const auto* refused = std::get_if<NotSpawned>(&event);
            refused != nullptr && refused->kind == kind)
            return refusal_text(refused->reason) + (", weight " + number.colour(refused->weight));
    return "followed";
}

std::string shadow_ray_text(const Trace& trace, const TracedRay& ray, int index, Id light,
                            const Numbers& number) {
    std::string text = shadow_ray_to(trace, index, light) == none ? "none" : "sent";
    for (const Event& event : ray.events)
        if (const auto* lit = std::get_if<LightLit>(&event); lit != nullptr && lit->light == light)
            text += "; n·l = " + number(lit->cosine);
    return text;
}

std::string visibility_text(const Trace& trace, const TracedRay& ray, const Numbers& number) {
    const Colour seen = ray.find<RayFinished>()->colour;
    std::string text = number.colour(seen);
    if (seen != Colour{0}) return text;
    const ObjectAccepted* blocker = nullptr; // the search ends at the object that blocks
    for (const Event& event : ray.events)
        if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) blocker = accepted;
    if (blocker == nullptr) return text;
    return text + ": " + object_name(trace, blocker->object) + " is in the way, at t = " + number(blocker->t);
}

} // namespace

std::string question_text(const Trace& first, const Trace& second, const Difference& difference) {
    const std::string light = difference.light == none ? "" : "light " + light_name(first, difference.light);
    switch (difference.answer) {
    case Answer::spans: return "how often the line is inside " + node_text(first, second, difference);
    case Answer::hit: return "whether anything is hit";
    case Answer::object: return "which object is hit";
    case Answer::face: return "which surface is hit";
    case Answer::side: return "whether the ray enters or leaves";
    case Answer::media: return "which media the ray travels in";
    case Answer::local_light: return "whether the hit is lit";
    case Answer::shadow_ray: return "whether a shadow ray asks for " + light;
    case Answer::total: return "whether reflection is total";
    case Answer::followed: return std::string("whether a ") + name_of(difference.next) + " ray follows";
    case Answer::given: return std::string(difference.what) + (light.empty() ? "" : " of ") + light;
    case Answer::weight: return "the ray's weight";
    case Answer::share:
        return difference.next == RayKind::reflected ? "the share of the light that is mirrored"
                                                     : "the share of the light that goes through";
    case Answer::origin: return "the ray's origin";
    case Answer::direction:
        return difference.next == RayKind::reflected || difference.next == RayKind::refracted
                   ? std::string("the direction of the ") + name_of(difference.next) + " ray"
                   : "the ray's direction";
    case Answer::t: return "t of the hit";
    case Answer::normal: return "the normal at the hit";
    case Answer::cosine: return "n·l, the cosine between normal and " + light;
    case Answer::mirror_cosine: return "r·v, the cosine between the mirrored " + light + " and the viewer";
    case Answer::visibility:
        return "what is seen of light " +
               light_name(first, first.rays[std::size_t(difference.ray)].start().light);
    }
    return "";
}

std::string answer_text(const Trace& trace, const Difference& difference, bool is_first,
                        const Numbers& number) {
    const TracedRay& ray = trace.rays[std::size_t(difference.ray)];
    const Vec3d& value = is_first ? difference.first : difference.second;
    switch (difference.answer) {
    case Answer::spans: {
        const int count = int(value.x);
        return count == 0 ? "never" : count == 1 ? "once" : std::to_string(count) + " times";
    }
    case Answer::hit:
    case Answer::object:
    case Answer::face:
    case Answer::side: return hit_text(trace, ray, number);
    case Answer::media: return media_text(trace, ray);
    case Answer::local_light:
        return ray.find<LocalLightSkipped>() == nullptr ? "it is lit"
                                                        : "it is not: the ray leaves a solid that transmits";
    case Answer::shadow_ray: return shadow_ray_text(trace, ray, difference.ray, difference.light, number);
    case Answer::total: return ray.find<TotallyReflected>() == nullptr ? "it is not" : "it is";
    case Answer::followed: return follow_text(ray, difference.next, number);
    case Answer::visibility: return visibility_text(trace, ray, number);
    case Answer::given: return number.colour(value);
    default: return difference.is_vector ? number.vector(value) : number(value.x);
    }
}

} // namespace rayscope::cli
