#include "exercises/grader/divergence_text.hpp"

#include "exercises/grader/trace_text.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope::exercises {
namespace {

std::string ray_text(const Trace& trace, std::size_t number) {
    if (number >= trace.rays.size()) return "there is no such ray";
    const TracedRay& ray = trace.rays[number];
    const RaySpawned& start = ray.start();
    std::string text = fmt::format("{} ray from {}, direction {}", name_of(start.kind),
                                   vector_text(start.origin), vector_text(start.direction));
    if (start.kind == RayKind::shadow) return text;
    const auto* hit = ray.find<BoundaryChosen>();
    if (hit == nullptr) return text + ": hits nothing";
    return text + fmt::format(": hits {} at t = {:.6g}, normal {}",
                              trace.objects[std::size_t(hit->object)].name, hit->boundary.t,
                              vector_text(hit->normal));
}

const char* question(Answer answer) {
    switch (answer) {
    case Answer::given: return "a colour or a coefficient that the scene gives";
    case Answer::spans: return "how many spans an object has on the ray";
    case Answer::hit: return "whether the ray hits anything";
    case Answer::object: return "which object the ray hits";
    case Answer::face: return "which face of it the ray hits";
    case Answer::side: return "whether the ray enters or leaves";
    case Answer::media: return "from which medium into which the ray goes";
    case Answer::local_light: return "whether local light is computed";
    case Answer::shadow_ray: return "whether a light is asked for";
    case Answer::total: return "whether the reflection is total";
    case Answer::followed: return "whether a ray goes on";
    case Answer::weight: return "the weight of the ray";
    case Answer::share: return "the share of the light that is mirrored or goes through";
    case Answer::origin: return "where the ray starts";
    case Answer::direction: return "the direction of a ray";
    case Answer::t: return "the t of the hit";
    case Answer::normal: return "the normal";
    case Answer::cosine: return "the cosine between normal and light";
    case Answer::mirror_cosine: return "the cosine between the mirrored light and the way back";
    case Answer::visibility: return "what is seen of a light";
    }
    return "";
}

/// Of a number or a count; what is yes or no shows in the rays.
std::string values_text(const Difference& difference) {
    if (difference.answer != Answer::spans && difference.answer < Answer::weight) return "";
    const auto text = [&](const Vec3d& value) {
        return difference.is_vector ? vector_text(value) : fmt::format("{:.9g}", value.x);
    };
    return fmt::format("  right  {}\n  yours  {}\n", text(difference.first), text(difference.second));
}

} // namespace

DivergenceText divergence_text(const Trace& right, const Trace& yours) {
    const Precision precision = precision_of(ScalarType::float64);
    const Comparison comparison = compare(right, yours, precision, precision);
    // A normal that lies elsewhere is seen by what it does to light and rays.
    if (!comparison.divergence)
        return {fmt::format("Both runs agree: {} rays, the same hits, lights and rays that follow.\n",
                            comparison.rays),
                false};
    const Difference& first = *comparison.divergence;
    std::string text;
    for (std::size_t i = 0; i < std::min(std::size_t(first.ray), right.rays.size()); ++i)
        text += fmt::format("ray {}, both: {}\n", i, ray_text(right, i));
    text += fmt::format("\nThe first divergence, at ray {}: {}\n{}\n", first.ray, question(first.answer),
                        values_text(first));
    for (const auto& [whose, trace] : {std::pair{"right", &right}, std::pair{"yours", &yours}}) {
        const auto number = std::size_t(first.ray);
        text += fmt::format("{}  ray {}: {}\n", whose, number, ray_text(*trace, number));
        if (number < trace->rays.size())
            for (const int child : trace->rays[number].children)
                text += fmt::format("       ray {}: {}\n", child, ray_text(*trace, std::size_t(child)));
    }
    text += fmt::format("\ncolour of the ray:  right {}, yours {}\n", vector_text(right.colour),
                        vector_text(yours.colour));
    return {text, true};
}

} // namespace rayscope::exercises
