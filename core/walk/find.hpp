#pragma once
// Which pixels of an image have a trace in which something happens.

#include "core/image/map.hpp"
#include "core/scene/scene.hpp"
#include "core/tracer/render.hpp"
#include "core/walk/expression.hpp"

namespace rayscope {

struct FindOptions {
    RenderOptions render; ///< size, threads, stage, progress and stop
    /// By the way of stages, of which the events tell then; else of every object.
    bool by_stage = false;
};

struct FindResult {
    Map events;     ///< of each pixel: at how many events the condition holds
    int pixels = 0; ///< at which it holds at least once
    int cut = 0;    ///< whose record was full: there it may hold unseen
    bool complete = true;
};

/// Traces the middle of each pixel with everything recorded, and looks at each event.
/// @param condition which needs no other run; names are those of the scene
[[nodiscard]] FindResult find(const Scene& scene, const World<double>& world, const Expression& condition,
                              const FindOptions& options);

/// The first event of a trace at which a condition holds, in time; and how many there are.
struct Occurrence {
    int ray = 0, event = 0, count = 0;
};
[[nodiscard]] std::optional<Occurrence> first_occurrence(const Trace& trace, const Expression& condition);

/// The names of a scene, for expressions.
[[nodiscard]] Vocabulary vocabulary_of(const Scene& scene);

} // namespace rayscope
