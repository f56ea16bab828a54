#include "core/csg/truth_table.hpp"

namespace rayscope {
namespace {

// Bit s of the table of operand i alone is bit i of s.
constexpr std::array<std::uint64_t, TruthTable::most> tables_of_operands{
    0xAAAAAAAAAAAAAAAA, 0xCCCCCCCCCCCCCCCC, 0xF0F0F0F0F0F0F0F0,
    0xFF00FF00FF00FF00, 0xFFFF0000FFFF0000, 0xFFFFFFFF00000000};

struct Part {
    std::uint64_t inside;
    unsigned operands; // a bit for each
};

} // namespace

bool TruthTable::lies_within(std::size_t operand) const {
    return (inside & ~tables_of_operands[operand]) == 0;
}

TruthTable truth_table(std::span<const Instruction> program) {
    TruthTable table;
    std::vector<Part> stack;
    for (const Instruction& step : program) {
        if (step.kind == Instruction::Kind::complement) return {};
        if (step.kind == Instruction::Kind::leaf) {
            if (table.count == TruthTable::most) return {};
            stack.push_back({tables_of_operands[table.count], 1U << table.count});
            ++table.count;
        } else if (step.kind == Instruction::Kind::combine) {
            const Part right = stack.back();
            stack.pop_back();
            Part& left = stack.back();
            switch (step.operation) {
            case Operation::set_union: left.inside |= right.inside; break;
            case Operation::intersection: left.inside &= right.inside; break;
            default: left.inside &= ~right.inside; table.flipped ^= right.operands;
            }
            left.operands |= right.operands;
        }
    }
    table.inside = stack.back().inside;
    return table;
}

} // namespace rayscope
