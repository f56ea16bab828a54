#include "tests/oracle/comparison.hpp"

#include "tests/oracle/nearness.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rayscope::test {
namespace {

constexpr long double endless = infinity<long double>;

// NaN if a component is.
double distance(const Vec3d& a, const Vec3d& b) { return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z); }

Piece ends_of(const LineCase& exact, const ExactSpan& span) {
    return {span.enter ? static_cast<long double>(exact.bounds[*span.enter].t.value()) : -endless,
            span.exit ? static_cast<long double>(exact.bounds[*span.exit].t.value()) : endless};
}

Fault fault_in_bound(const LineCase& exact, const std::optional<std::size_t>& index, const FoundEnd& found,
                     double unbounded, bool loose) {
    if (!index)
        return found.t == unbounded ? Fault{}
                                    : Fault{text("t = ", hex(found.t), " where the span is unbounded")};
    const ExactBound& bound = exact.bounds[*index];
    const double allowed = loose ? bound.tolerance : bound.tight_tolerance * allowed_share;
    const double error = bound.t.distance(found.value());
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
    Float128 last = -infinity<Float128>;
    for (const FoundSpan& span : found) {
        if (std::isnan(span.enter.t) || std::isnan(span.exit.t)) return "a t is NaN";
        if (std::isnan(span.enter.error_bound) || std::isnan(span.exit.error_bound))
            return "an error bound is NaN";
        if (!(span.enter.value() < span.exit.value()))
            return text("a span is empty or reversed at t = ", hex(span.enter.t));
        if (span.enter.value() < last) return text("spans overlap at t = ", hex(span.enter.t));
        last = span.exit.value();
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

std::vector<Piece> symmetric_difference(const LineCase& exact, const FoundSpans& found) {
    std::vector<Piece> in_exact, in_found;
    for (const ExactSpan& span : exact.spans) in_exact.push_back(ends_of(exact, span));
    for (const FoundSpan& span : found)
        in_found.push_back({static_cast<long double>(span.enter.t), static_cast<long double>(span.exit.t)});
    std::vector<long double> ends{-endless, endless};
    for (const auto* pieces : {&in_exact, &in_found})
        for (const Piece& piece : *pieces) ends.insert(ends.end(), {piece.from, piece.to});
    std::ranges::sort(ends);

    const auto covers = [](const std::vector<Piece>& pieces, const Piece& part) {
        return std::ranges::any_of(
            pieces, [&](const Piece& piece) { return piece.from <= part.from && part.to <= piece.to; });
    };
    std::vector<Piece> difference;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Piece part{ends[i], ends[i + 1]};
        if (part.from < part.to && covers(in_exact, part) != covers(in_found, part))
            difference.push_back(part);
    }
    return difference;
}

Fault fault_in_measure(const LineCase& exact, const FoundSpans& found) {
    const auto is_doubtful = [&](const Piece& piece) {
        const long double middle = piece.from + (piece.to - piece.from) / 2;
        return std::isfinite(middle) && std::ranges::any_of(exact.leaves, [&](const CaseLeaf& leaf) {
                   return PointInLeaf(leaf, exact.ray, middle, exact.epsilon).is_near_surface();
               });
    };
    long double length = 0;
    for (const Piece& piece : symmetric_difference(exact, found))
        if (!is_doubtful(piece)) length += piece.to - piece.from;
    if (length <= static_cast<long double>(exact.tolerance_sum)) return {};
    return text("the spans differ on a length of ", length, ", allowed are ", exact.tolerance_sum);
}

Fault fault_in_case(const LineCase& exact, const FoundSpans& found) {
    if (auto fault = fault_in_order(found)) return fault;
    if (exact.in_surface) return {};
    if (exact.decidable) return fault_in_spans(exact, exact.spans, found);
    if (exact.clean_decidable) return fault_in_spans(exact, exact.clean_spans, found, true);
    return fault_in_measure(exact, found);
}

Fault fault_in_end(const LineCase& exact, const ExactBound& bound, const FoundEnd& found) {
    std::optional<Vec3d> normal;
    bool meets = false, meets_leaf = false;
    for (const ExactSurface& surface : bound.surfaces) {
        if (surface.leaf != found.leaf || surface.flipped != found.flipped) continue;
        meets_leaf = true;
        if (surface.face != found.face) continue;
        meets = true;
        normal = surface.normal;
    }
    if (!meets && meets_leaf) {
        const PointInLeaf point(exact.leaves[found.leaf], exact.ray,
                                static_cast<long double>(bound.t.value()), exact.epsilon);
        meets = point.is_near(found.face);
        normal = point.normal(found.face);
        if (found.flipped) normal = -*normal;
    }
    if (!meets)
        return text("at t = ", hex(found.t), " the surface is leaf ", found.leaf, ", face ", found.face,
                    found.flipped ? ", flipped" : "", ", which does not meet that point");
    // Where the file states no tolerance for the normal: the scales of its leaves and the lengths of its rays
    // are mild, so that the error of the point turns it by less than a hundred times itself.
    const double allowed =
        bound.normal_tolerance.value_or(1e-10 * exact.epsilon / epsilon<double> + 100 * bound.tolerance);
    const double off = normal ? distance(*normal, found.normal) : 0;
    if (off <= allowed) return {};
    return text("at t = ", hex(found.t), " the normal ", hex(found.normal), " is off by ", hex(off),
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
