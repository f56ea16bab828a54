// Commands that ask why a ray went by: objects, cells.

#include "visualizer/cli/arguments.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/second_run.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/cli/why_text.hpp"

#include <limits>

namespace rayscope::cli {
namespace {

std::string interval(const BoxSpan<double>& span, const Numbers& number) {
    return "t = " + number(span.enter) + " … " + number(span.exit);
}

std::string cell_reason(const WhyNotCell& why, double reach, const Numbers& number) {
    switch (why.reason) {
    case WhyNotCell::Reason::box_missed: {
        std::string text = "the ray's line is never between all its planes: across x for " +
                           interval(why.between[0], number) + ", y for " + interval(why.between[1], number) +
                           ", z for " + interval(why.between[2], number);
        return text + ", so it would enter at " + number(why.inside.enter) + " and have left at " +
               number(why.inside.exit);
    }
    case WhyNotCell::Reason::behind:
        return "it lies behind the ray's origin, at " + interval(why.inside, number);
    case WhyNotCell::Reason::contents_missed:
        return "the ray passes the cell at " + interval(why.inside, number) + ", but on level " +
               std::to_string(why.level) + " it misses the box of what objects have in there";
    case WhyNotCell::Reason::beyond_reach:
        return "it begins at t = " + number(why.inside.enter) +
               ", beyond the hit or light at t = " + number(reach);
    case WhyNotCell::Reason::looked_into: return "it was looked into, at " + interval(why.inside, number);
    }
    return "";
}

} // namespace

std::string Session::why(const std::string& what) {
    Page page(style_.paint);
    if (what.starts_with("cell ")) {
        const int cell = parse_count("why-not cell", what.substr(5), 0, std::numeric_limits<int>::max());
        const auto stages = make_stages(bench_, stage_choice("octree"));
        const auto why = why_not_cell(*stages, trace(), std::size_t(current()), std::uint32_t(cell));
        if (!why) throw UsageError("why-not: the octree of this scene has no cell " + std::to_string(cell));
        const TracedRay& ray = trace().rays[std::size_t(current())];
        const auto* chosen = ray.find<BoundaryChosen>();
        page.line(
            "cell " + std::to_string(cell) + ": " +
            cell_reason(*why, chosen != nullptr ? chosen->boundary.t : ray.start().reach, style_.number));
        page.line("its box: " + style_.number.vector(why->box.low) + " to " +
                      style_.number.vector(why->box.high),
                  2);
        return page.text();
    }
    try {
        page.line(why_text(bench_, trace(), current(), find_drawn(bench_.scene, what), style_.number));
        return page.text();
    } catch (const UsageError& error) {
        throw UsageError("why: " + std::string(error.what()));
    }
}

std::string Session::cells(const std::string& stage) {
    Page page(style_.paint);
    if (stage.empty() && trace().rays[std::size_t(current())].find<SearchBegan>() != nullptr) {
        add_search(page, trace(), current(), style_);
        return page.text();
    }
    const SecondRun run = run_by_stage("cells", stage.empty() ? "octree" : stage, bench_, trace());
    // All stages follow the same rays; only a record that is full may lack some.
    if (std::size_t(current()) >= run.trace.rays.size()) return "The record of that search was full.\n";
    add_search(page, run.trace, current(), style_);
    return page.text();
}

} // namespace rayscope::cli
