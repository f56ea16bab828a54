// rayscope step --compare: where two runs of the same ray part.

#include "visualizer/cli/compare_text.hpp"

#include "visualizer/cli/answer_text.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/ray_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace rayscope::cli {
namespace {

bool is_number(Answer answer) { return answer >= Answer::weight && answer != Answer::visibility; }

class Comparer {
public:
    Comparer(const Run& a, const Run& b, const StepStyle& style)
        : first_(a.trace), second_(b.trace), names_{a.name, b.name}, style_(style), page_(style.paint) {
        const Precision of_first = precision_of(a.scalar), of_second = precision_of(b.scalar);
        narrower_ = of_first.epsilon < of_second.epsilon ? b.scalar : a.scalar;
        result_ = compare(first_, second_, of_first, of_second);
    }

    std::string text() {
        page_.item("A", names_[0]);
        page_.item("B", names_[1]);
        if (result_.divergence) {
            page_.rule(style_.paint.bold("The first divergence"));
            add(*result_.divergence);
        } else {
            add_agreement();
        }
        add_largest();
        add_colours();
        return page_.text();
    }

private:
    void add_agreement() {
        page_.rule(style_.paint.bold("No divergence"));
        const std::string rays = std::to_string(result_.rays) + (result_.rays == 1 ? " ray" : " rays");
        page_.line(result_.complete
                       ? rays + " in both runs: the same hits, lights and rays that follow, and no number "
                                "differs by more than the precision of both runs explains."
                       : "Compared as far as " + rays + " go: then a record was full, and nothing is known.",
                   2);
    }

    void add_largest() {
        if (!result_.largest) return;
        page_.rule(style_.paint.bold(result_.divergence ? "Before it: the largest difference in ulps"
                                                        : "The largest difference in ulps"));
        if (result_.largest->ulps == 0)
            page_.line("None: every number is the same, bit for bit as a double.", 2);
        else
            add(*result_.largest);
    }

    void add(const Difference& difference) {
        const RaySpawned& start = first_.rays[std::size_t(difference.ray)].start();
        page_.item("ray", style_.paint.kind(start.kind,
                                            std::to_string(difference.ray) + ", " + name_of(start.kind)) +
                              ", depth " + std::to_string(start.depth));
        page_.item("asked", question_text(first_, second_, difference));
        page_.item("A", answer_text(first_, difference, true, style_.number));
        page_.item("B", answer_text(second_, difference, false, style_.number));
        if (is_number(difference.answer)) add_sizes(difference);
    }

    void add_sizes(const Difference& difference) {
        const Numbers& number = style_.number;
        std::string text = number(difference.size) + " = " + Numbers(3)(difference.ulps) + " ulps of " +
                           std::string(scalar_name(narrower_));
        if (difference.bounds > 0)
            text += " = " + Numbers(3)(difference.size / difference.bounds) +
                    " error bounds (of both runs together: " + number(difference.bounds) + ")";
        page_.item("difference", text);
        if (difference.answer == Answer::normal)
            page_.item("explained", "not judged: nothing is recorded that bounds a normal");
        else
            page_.item("explained", "at most " + number(difference.explained) +
                                        ", by rounding and by what the step began with");
    }

    void add_colours() {
        page_.rule(style_.paint.bold("The colours"));
        int most = 0;
        const auto a = srgb_bytes(first_.colour), b = srgb_bytes(second_.colour);
        for (std::size_t i = 0; i < 3; ++i) most = std::max(most, std::abs(int(a[i]) - int(b[i])));
        for (const auto& [name, trace, bytes] : {std::tuple("A", &first_, a), std::tuple("B", &second_, b)})
            page_.item(name, style_.number.vector(trace->colour) +
                                 fmt::format(", #{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]));
        page_.item("", most == 0 ? "the same in a PNG"
                                 : "in a PNG they differ by up to " + std::to_string(most) + " of 255");
    }

    const Trace &first_, &second_;
    std::array<std::string, 2> names_;
    const StepStyle& style_;
    Page page_;
    ScalarType narrower_ = ScalarType::float64;
    Comparison result_;
};

} // namespace

Configuration chosen_configuration(const std::string& option, const std::string& list,
                                   const Configuration& base) {
    try {
        return configuration(list, base);
    } catch (const std::invalid_argument& error) {
        throw UsageError(option + ": " + error.what());
    }
}

Trace traced_again(const Workbench& bench, const Trace& trace, const Configuration& configuration) {
    const TraceSource& source = trace.source;
    if (!source.by_hand) return trace_pixel(bench, configuration, source.x, source.y);
    const RaySpawned& start = trace.rays.front().start(); // as it was given
    return trace_ray(bench, configuration, {start.origin, start.direction});
}

std::string compare_text(const Run& first, const Run& second, const StepStyle& style) {
    return Comparer(first, second, style).text();
}

} // namespace rayscope::cli
