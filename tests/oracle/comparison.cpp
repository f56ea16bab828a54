#include "tests/oracle/comparison.hpp"

#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rayscope::test {
namespace {

constexpr long double endless = infinity<long double>;

struct ExactEnds {
    long double enter, exit;
};

// NaN if a component is.
double distance(const Vec3d& a, const Vec3d& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

ExactEnds ends_of(const LineCase& exact, const ExactSpan& span) {
    return {span.enter ? exact.bounds[*span.enter].t.value() : -endless,
            span.exit ? exact.bounds[*span.exit].t.value() : endless};
}

Fault fault_in_bound(const LineCase& exact, const std::optional<std::size_t>& index, const FoundEnd& found,
                     double unbounded, bool loose) {
    if (!index)
        return found.t == unbounded ? Fault{}
                                    : Fault{text("t = ", hex(found.t), " where the span is unbounded")};
    const ExactBound& bound = exact.bounds[*index];
    const double allowed = loose ? bound.tolerance : bound.tight_tolerance * allowed_share;
    const double error = bound.t.distance(found.t);
    if (error <= allowed) return {};
    return text("t = ", hex(found.t), " is off by ", error / allowed, " times the allowed ", hex(allowed));
}

std::string describe(const std::vector<CaseToken>& program) {
    constexpr std::size_t shown = 64;
    constexpr std::array symbols{' ', '|', '&', '-', '~'};
    std::string result;
    for (std::size_t i = 0; i < std::min(shown, program.size()); ++i) {
        const CaseToken& token = program[i];
        if (token.operation == Operation::leaf)
            result += text(' ', token.leaf);
        else
            result += text(' ', symbols[static_cast<std::size_t>(token.operation)]);
    }
    if (program.size() > shown) result += text(" … (", program.size(), " tokens)");
    return result;
}

} // namespace

Fault fault_in_order(const FoundSpans& found) {
    double last = -infinity<double>;
    for (const FoundSpan& span : found) {
        if (std::isnan(span.enter.t) || std::isnan(span.exit.t)) return "a t is NaN";
        if (std::isnan(span.enter.error_bound) || std::isnan(span.exit.error_bound))
            return "an error bound is NaN";
        if (!(span.enter.t < span.exit.t))
            return text("a span is empty or reversed at t = ", hex(span.enter.t));
        if (span.enter.t < last) return text("spans overlap at t = ", hex(span.enter.t));
        last = span.exit.t;
    }
    return {};
}

Fault fault_in_spans(const LineCase& exact, const std::vector<ExactSpan>& spans, const FoundSpans& found,
                     bool loose) {
    if (spans.size() != found.size()) return text(found.size(), " spans where there are ", spans.size());
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (auto fault = fault_in_bound(exact, spans[i].enter, found[i].enter, -infinity<double>, loose))
            return fault;
        if (auto fault = fault_in_bound(exact, spans[i].exit, found[i].exit, infinity<double>, loose))
            return fault;
    }
    return {};
}

double symmetric_difference(const LineCase& exact, const FoundSpans& found) {
    std::vector<long double> ends{-endless, endless};
    for (const ExactSpan& span : exact.spans) {
        const auto [enter, exit] = ends_of(exact, span);
        ends.insert(ends.end(), {enter, exit});
    }
    for (const FoundSpan& span : found)
        ends.insert(ends.end(),
                    {static_cast<long double>(span.enter.t), static_cast<long double>(span.exit.t)});
    std::ranges::sort(ends);
    long double length = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const long double from = ends[i], to = ends[i + 1];
        if (!(from < to)) continue;
        const bool in_exact = std::ranges::any_of(exact.spans, [&](const ExactSpan& span) {
            const auto [enter, exit] = ends_of(exact, span);
            return enter <= from && to <= exit;
        });
        const bool in_found = std::ranges::any_of(found, [&](const FoundSpan& span) {
            return static_cast<long double>(span.enter.t) <= from &&
                   to <= static_cast<long double>(span.exit.t);
        });
        if (in_exact != in_found) length += to - from;
    }
    return static_cast<double>(length);
}

Fault fault_in_measure(const LineCase& exact, const FoundSpans& found) {
    double allowed = exact.tolerance_sum;
    for (const FoundSpan& span : found) allowed += 2 * (span.enter.error_bound + span.exit.error_bound);
    const double length = symmetric_difference(exact, found);
    if (length <= allowed) return {};
    return text("the spans differ on a length of ", hex(length), ", allowed are ", hex(allowed));
}

Fault fault_in_case(const LineCase& exact, const FoundSpans& found) {
    if (auto fault = fault_in_order(found)) return fault;
    if (exact.in_surface) return {};
    if (exact.decidable) return fault_in_spans(exact, exact.spans, found);
    if (exact.clean_decidable) return fault_in_spans(exact, exact.clean_spans, found, true);
    return fault_in_measure(exact, found);
}

Fault fault_in_end(const ExactBound& exact, const FoundEnd& found, bool surfaces) {
    // Where the file states no tolerance for the normal: the scales of its leaves and the lengths of its rays are
    // mild, so that the error of the point turns it by less than a hundred times itself.
    const double allowed = exact.normal_tolerance.value_or(1e-10 + 100 * exact.tolerance);
    bool meets = false;
    double least = infinity<double>;
    for (const ExactSurface& surface : exact.surfaces) {
        if (surfaces &&
            (surface.leaf != found.leaf || surface.face != found.face || surface.flipped != found.flipped))
            continue;
        meets = true;
        const double off = surface.normal ? distance(*surface.normal, found.normal) : 0.0;
        if (off < least) least = off;
    }
    if (least <= allowed) return {};
    if (!meets)
        return text("at t = ", hex(found.t), " the surface is leaf ", found.leaf, ", face ", found.face,
                    found.flipped ? ", flipped" : "", ", which does not meet that point");
    return text("at t = ", hex(found.t), " the normal ", hex(found.normal), " is off by ", hex(least),
                ", allowed are ", hex(allowed));
}

std::vector<MatchedEnd> matched_ends(const LineCase& exact, const std::vector<ExactSpan>& spans,
                                     const FoundSpans& found) {
    std::vector<MatchedEnd> ends;
    if (spans.size() != found.size()) return ends;
    for (std::size_t i = 0; i < spans.size(); ++i) {
        if (spans[i].enter) ends.push_back({&exact.bounds[*spans[i].enter], &found[i].enter});
        if (spans[i].exit) ends.push_back({&exact.bounds[*spans[i].exit], &found[i].exit});
    }
    return ends;
}

std::string describe(const LineCase& exact, const FoundSpans& found) {
    std::string result = text(exact.id, "\n  ray ", hex(exact.ray));
    for (std::size_t i = 0; i < exact.leaves.size(); ++i) {
        const CaseLeaf& leaf = exact.leaves[i];
        result += text("\n  leaf ", i, ": ", generic_name(leaf.shape));
        if (const auto* torus = std::get_if<Torus<double>>(&leaf.shape))
            result += text(", minor radius ", hex(torus->minor));
        result += text(", matrix by columns ", hex(leaf.matrix));
    }
    if (exact.is_compound) result += text("\n  program", describe(exact.program));
    result += "\n  expected";
    for (const ExactSpan& span : exact.spans)
        result += text(" [", span.enter ? hex(exact.bounds[*span.enter].t.nearest) : "-inf", ", ",
                       span.exit ? hex(exact.bounds[*span.exit].t.nearest) : "inf", "]");
    result += "\n  found   ";
    for (const FoundSpan& span : found) result += text(" [", hex(span.enter.t), ", ", hex(span.exit.t), "]");
    return result;
}

} // namespace rayscope::test
