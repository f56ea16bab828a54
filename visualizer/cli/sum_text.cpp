// Sums: one ray's, and the pixel's.

#include "visualizer/cli/explain_text.hpp"
#include "visualizer/cli/ray_facts.hpp"
#include "visualizer/cli/step_text.hpp"

#include <fmt/format.h>

namespace rayscope::cli {
namespace {

double total(const Colour& colour) { return colour.x + colour.y + colour.z; }

/// "text = result", and the percentage at the right edge of its last line.
void add_row(Page& page, const std::string& label, const std::string& product, const std::string& result,
             const std::string& share) {
    constexpr std::size_t label_width = 25, share_width = 9;
    const std::string start =
        "  " + label + std::string(columns(label) < label_width ? label_width - columns(label) : 1, ' ');
    const std::size_t indent = columns(start);
    const std::string whole = product + " = " + result;
    const auto padded = [&](const std::string& text) {
        const std::size_t used = indent + columns(text) + columns(share);
        return text + (used < page_width ? std::string(page_width - used, ' ') : " ") + share;
    };
    // The page would break the padding: these lines are set here, with blanks that do not break.
    const auto add = [&](const std::string& first, const std::string& text) {
        std::string fixed;
        for (const char c : text) fixed += c == ' ' ? std::string(glue) : std::string(1, c);
        page.line(first, std::string(indent, ' '), fixed);
    };
    if (indent + columns(whole) + share_width <= page_width) {
        add(start, padded(whole));
    } else {
        page.line(start, std::string(indent, ' '), product);
        add(std::string(indent, ' '), padded("= " + result));
    }
}

} // namespace

void add_sum(Page& page, const Trace& trace, int index, const StepStyle& style) {
    const TracedRay& ray = trace.rays[std::size_t(index)];
    const Numbers& number = style.number;
    const auto* end = ray.find<RayFinished>();
    if (end == nullptr) return;
    page.heading("Colour that it brings back");
    page.item(ray.find<Missed>() != nullptr ? "background" : "local", number.colour(end->local));
    for (const int child : ray.children) {
        const TracedRay& other = trace.rays[std::size_t(child)];
        const auto* brought = other.find<RayFinished>();
        if (other.start().kind == RayKind::shadow || brought == nullptr) continue;
        const Colour coefficient = coefficient_of(trace, child);
        page.item("+ " + style.paint.kind(other.start().kind, "ray " + std::to_string(child)),
                  number.colour(coefficient) + " × " + number.colour(brought->colour) + " =" + glue +
                      number.colour(coefficient * brought->colour));
    }
    page.item("= colour", style.paint.bold(number.colour(end->colour)));
}

std::string result_text(const Trace& trace, const StepStyle& style) {
    const Numbers& number = style.number;
    Page page(style.paint);
    page.rule(style.paint.bold(trace.source.by_hand ? "The colour of the ray" : "The colour of the pixel"));
    const auto bytes = srgb_bytes(trace.colour);
    page.item("linear", number.vector(trace.colour));
    page.item("sRGB", fmt::format("#{:02x}{:02x}{:02x}", bytes[0], bytes[1], bytes[2]));
    page.heading("Where it comes from: weight × what the ray finds itself; share of R + G + B");
    Colour sum{0};
    std::size_t silent = 0;
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        const auto* end = ray.find<RayFinished>();
        if (ray.start().kind == RayKind::shadow || end == nullptr) continue;
        const Colour part = ray.start().weight * end->local;
        sum += part;
        if (part == Colour{0}) {
            ++silent;
            continue;
        }
        const std::string what = ray.find<Missed>() != nullptr ? ", background" : ", local";
        add_row(page,
                style.paint.kind(ray.start().kind, std::to_string(i) + " " + name_of(ray.start().kind)) +
                    what,
                number.colour(ray.start().weight) + " × " + number.colour(end->local), number.colour(part),
                fmt::format("{:.1f} %", 100 * total(part) / total(trace.colour)));
    }
    if (silent > 0)
        page.line(std::to_string(silent) +
                      (silent == 1 ? " ray adds nothing of its own." : " rays add nothing of their own."),
                  2);
    page.item("sum", number.vector(sum));
    page.item("colour", number.vector(trace.colour));
    if (trace.events_dropped > 0)
        page.line("The record was full, so the sum lacks the rays that are missing.", 2);
    return page.text();
}

std::string ledger_text(const Trace& trace, const StepStyle& style) {
    Page page(style.paint);
    add_ledger(
        page, ledger_of(trace.rays), "the pixel", [&](Id object) { return object_name(trace, object); },
        style.number);
    return page.text();
}

} // namespace rayscope::cli
