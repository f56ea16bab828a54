#pragma once
// A compound of few operands as a table: which of them hold a point says whether the compound does.

#include "core/csg/program.hpp"

namespace rayscope {

/// A state is a number whose bit i says whether a point is inside operand i, counted in the program's order.
struct TruthTable {
    static constexpr std::size_t most = 6; ///< operands: their 64 states are the bits of one word

    std::uint64_t inside = 0; ///< bit s: a point with state s is inside the compound
    unsigned flipped = 0;     ///< bit i: operand i is part of what is subtracted: its normal is turned
    std::size_t count = 0;    ///< of operands; 0: there is no table

    [[nodiscard]] bool holds(unsigned state) const { return ((inside >> state) & 1U) != 0; }
    /// Whether nothing of the compound lies outside of this operand.
    [[nodiscard]] bool lies_within(std::size_t operand) const;
};

/// None where the program has more operands, or a complement: then a point outside all operands may be inside.
[[nodiscard]] TruthTable truth_table(std::span<const Instruction> program);

/// The ends of the operands' intervals along a ray, one interval for each operand at most, in ascending order.
template <Scalar T> class OperandEnds {
public:
    struct End {
        T t;
        std::uint32_t solid;
        std::int32_t face;
        std::uint8_t operand; ///< number of the solid
        bool entering;
    };

    void add(const Interval<T>& inside, std::uint32_t solid, std::size_t operand) {
        insert({inside.enter, solid, std::int32_t(inside.enter_face), std::uint8_t(operand), true});
        insert({inside.exit, solid, std::int32_t(inside.exit_face), std::uint8_t(operand), false});
    }
    /// Two ends have the same finite t: whose face it is then depends on the tree, which no table knows.
    [[nodiscard]] bool tied() const { return tied_; }
    [[nodiscard]] const End* begin() const { return ends_.data(); }
    [[nodiscard]] const End* end() const { return ends_.data() + count_; }

    /// Appends where the ray enters and leaves the compound.
    void sweep(const TruthTable& table, SpanStack<T>& list) const {
        unsigned state = 0;
        bool inside = false;
        for (std::size_t i = 0; i < count_; ++i) {
            const End& end = ends_[i];
            state ^= 1U << end.operand;
            const bool more_at_infinity = i + 1 < count_ && ends_[i + 1].t == end.t;
            if (more_at_infinity || table.holds(state) == inside) continue;
            inside = !inside;
            list.append({end.t, {end.solid, end.face, ((table.flipped >> end.operand) & 1U) != 0}, inside});
        }
    }

private:
    void insert(const End& end) {
        std::size_t at = count_++;
        for (; at > 0 && !(ends_[at - 1].t < end.t); --at) {
            tied_ = tied_ || (ends_[at - 1].t == end.t && is_finite(end.t));
            ends_[at] = ends_[at - 1];
        }
        ends_[at] = end;
    }

    std::array<End, 2 * TruthTable::most> ends_; // the first count_
    std::size_t count_ = 0;
    bool tied_ = false;
};

/// Runs a program that has a truth table, where each operand is one interval of a line. A part whose interval is surely
/// empty is left out, as by `run`.
/// @param interval called as interval(solid): the operand's inside interval, empty or not
/// @param misses   called as misses(extent): whether the ray's line misses it
/// @param ends     takes the ends of all intervals
/// @return false where the compound surely has no point on the line
template <Scalar T, typename IntervalOf, typename Misses>
[[nodiscard]] bool gather_ends(std::span<const Instruction> program, std::span<const PartExtent> extents,
                               const IntervalOf& interval, Misses&& misses, OperandEnds<T>& ends) {
    struct Hull { // what a part of the program can hold lies within it
        T enter, exit;
        [[nodiscard]] bool empty() const { return !(enter < exit); }
    };
    constexpr Hull nothing{infinity<T>, -infinity<T>};
    Hull top = nothing;
    std::array<Hull, TruthTable::most + 1> below;
    std::size_t depth = 0, operand = 0;
    const auto push = [&](const Hull& hull) {
        below[depth++] = top;
        top = hull;
    };
    for (std::size_t i = 0; i < program.size(); ++i) {
        const Instruction& step = program[i];
        // Operands that are left out keep their numbers.
        const auto skip_to = [&](std::size_t end) {
            for (++i; i < end; ++i) operand += std::size_t(program[i].kind == Instruction::Kind::leaf);
            --i;
        };
        switch (step.kind) {
        case Instruction::Kind::leaf: {
            const Interval<T> inside = interval(step.operand);
            if (!inside.empty()) ends.add(inside, step.operand, operand);
            push({inside.enter, inside.exit});
            ++operand;
            break;
        }
        case Instruction::Kind::guard:
            if (top.empty()) skip_to(step.operand);
            break;
        case Instruction::Kind::extent:
            if (misses(step.operand)) {
                push(nothing);
                skip_to(extents[step.operand].end);
            }
            break;
        case Instruction::Kind::combine: {
            const Hull right = top;
            top = below[--depth]; // A − B lies within A
            if (step.operation == Operation::intersection)
                top = {maximum(top.enter, right.enter), minimum(top.exit, right.exit)};
            else if (step.operation == Operation::set_union && top.empty())
                top = right;
            else if (step.operation == Operation::set_union && !right.empty())
                top = {minimum(top.enter, right.enter), maximum(top.exit, right.exit)};
            break;
        }
        case Instruction::Kind::complement: break; // has no table
        }
    }
    return !top.empty();
}

} // namespace rayscope
