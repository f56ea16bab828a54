#pragma once
// Everything that one ray did, as plain data: the tree of rays, and tables that name what their events point at.

#include "core/trace/events.hpp"
#include "core/trace/operation.hpp"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rayscope {

/// One ray: its place in the tree, and its events in the order in which they happened.
struct TracedRay {
    int parent = none;
    std::vector<int> children; ///< in the order of spawning, shadow rays included
    std::vector<Event> events;

    /// The first event of a type, or nullptr. Every ray has a RaySpawned and, unless truncated, a RayFinished.
    template <typename E> [[nodiscard]] const E* find() const {
        for (const Event& event : events)
            if (const E* found = std::get_if<E>(&event)) return found;
        return nullptr;
    }
    [[nodiscard]] const RaySpawned& start() const { return std::get<RaySpawned>(events.front()); }
};

/// Which ray was traced: a sample of a pixel, or a ray given by hand.
struct TraceSource {
    std::string scene; ///< path of the scene file
    bool by_hand = false;
    int x = 0, y = 0, sample = 0; ///< pixel and sample, unless by hand
    double given_length = 1;      ///< |d| of a ray given by hand; its shading uses the normalized copy
};

struct TraceNode {
    Operation operation = Operation::leaf;
    Id left = none, right = none; ///< nodes of the same object
    Id generic = none;            ///< leaves: index into Trace::generics
    std::string name;             ///< a generic's or named sub-expression's name, else its expression
};

struct TraceObject {
    std::string name;
    std::string material;
    std::vector<TraceNode> nodes; ///< children before parents; the last one is the root
};

struct TraceMedium {
    std::string name;
    double speed = 1;
};

struct TraceLight {
    std::string name;
    bool directional = false;
    Vec3d position{0}; ///< or, for a directional light, the unit direction towards it
};

struct Trace {
    TraceSource source;
    int max_depth = 0;
    double min_weight = 0;
    Vec3d eye{0};
    std::vector<TraceObject> objects; ///< only those that an event names
    std::vector<std::string> generics;
    std::vector<TraceMedium> media;
    std::vector<TraceLight> lights;
    std::vector<TracedRay> rays;    ///< rays[0] is the first one; a child comes after its parent
    Colour colour{0};               ///< of the whole sample, linear
    std::size_t events_dropped = 0; ///< > 0: the cap on events was met, the tree is cut there
};

/// A ray's largest weight component.
[[nodiscard]] inline double weight(const TracedRay& ray) { return largest_component(ray.start().weight); }

/// The t at which a ray ends: its hit, the light (shadow rays), or nothing if it goes on forever.
[[nodiscard]] std::optional<double> end_of(const TracedRay& ray);

/// The spans that follow events[index], which must be a NodeEvaluated.
[[nodiscard]] std::vector<SpanFound> spans_after(const TracedRay& ray, std::size_t index);

} // namespace rayscope
