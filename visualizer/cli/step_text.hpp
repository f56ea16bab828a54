#pragma once
// A trace as text that can be checked by hand.

#include "visualizer/cli/numbers.hpp"
#include "visualizer/cli/page.hpp"

namespace rayscope::cli {

struct StepStyle {
    Numbers number;
    Paint paint;
};

/// The recursion as an indented tree; `current` is marked.
[[nodiscard]] std::string tree_text(const Trace& trace, const StepStyle& style, int current = none);

/// What became of a ray, such as "leaves bowl at t = 1.2".
[[nodiscard]] std::string ray_summary(const Trace& trace, int ray, const Numbers& number);

/// One ray: where it goes, what it meets, how it is lit, what it spawns, and its sum.
[[nodiscard]] std::string ray_text(const Trace& trace, int ray, const StepStyle& style);

/// The colour of the sample, and where each part of it came from.
[[nodiscard]] std::string result_text(const Trace& trace, const StepStyle& style);

/// That light by kind and object, and the weight of what was not followed.
[[nodiscard]] std::string ledger_text(const Trace& trace, const StepStyle& style);

// The parts of ray_text, in their order; each adds what its events say, or nothing.
void add_start(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_search(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_spans(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_hit(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_light(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_spawned(Page& page, const Trace& trace, int ray, const StepStyle& style);
void add_sum(Page& page, const Trace& trace, int ray, const StepStyle& style);

} // namespace rayscope::cli
