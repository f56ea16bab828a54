#include "core/csg/program.hpp"

namespace rayscope {
namespace {

// What is still to be written: a node, operands that one operation joins, a guard, the end of an extent, or the operation
// itself.
struct Pending {
    enum class Kind { node, operands, guard, end_extent, combine, complement } kind;
    std::uint32_t node = 0;
    Operation operation = Operation::leaf;
    std::vector<std::uint32_t> operands;
    Box<double> met; // by every line that comes here
};

using Nodes = std::span<const CompoundNode>;

// What a box has to save on the average, in tests of a box: itself, and again as much, for lines that meet one part of a
// compound meet its others more often than the surfaces say.
constexpr double least_gain = 3;

// The operands of a chain of one associative operation, from left to right.
std::vector<std::uint32_t> chain(Nodes nodes, std::uint32_t root) {
    const Operation operation = nodes[root].operation;
    std::vector<std::uint32_t> operands, open{root};
    while (!open.empty()) {
        const std::uint32_t at = open.back();
        open.pop_back();
        if (nodes[at].operation == operation) {
            open.push_back(nodes[at].right);
            open.push_back(nodes[at].left);
        } else {
            operands.push_back(at);
        }
    }
    return operands;
}

// D − A − B − C: the first operand, then all that is taken from it, from left to right.
std::vector<std::uint32_t> difference_chain(Nodes nodes, std::uint32_t root) {
    std::vector<std::uint32_t> operands;
    std::uint32_t at = root;
    for (; nodes[at].operation == Operation::difference; at = nodes[at].left)
        operands.push_back(nodes[at].right);
    operands.push_back(at);
    return {operands.rbegin(), operands.rend()};
}

// What each node costs, in tests of a box: its leaves, and a sweep for each operation.
std::vector<double> costs(Nodes nodes, std::span<const NodeExtent> extents) {
    constexpr double sweep = 2;
    std::vector<double> result;
    for (std::size_t i = 0; i < extents.size(); ++i) {
        const CompoundNode& node = nodes[i];
        switch (node.operation) {
        case Operation::leaf: result.push_back(extents[i].cost); break;
        case Operation::complement: result.push_back(result[node.left]); break;
        default: result.push_back(result[node.left] + result[node.right] + sweep);
        }
    }
    return result;
}

class Compiler {
public:
    Compiler(Nodes nodes, std::span<const NodeExtent> extents)
        : nodes_(nodes), node_extents_(extents), costs_(costs(nodes, extents)) {}

    CompiledProgram compile(const Box<double>& within) {
        then_node(std::uint32_t(nodes_.size() - 1), within);
        while (!todo_.empty()) {
            Pending next = std::move(todo_.back());
            todo_.pop_back();
            switch (next.kind) {
            case Pending::Kind::guard: open_guard(); break;
            case Pending::Kind::end_extent: end_extent(); break;
            case Pending::Kind::combine: combine(next.operation); break;
            case Pending::Kind::complement: program_.push_back({Instruction::Kind::complement}); break;
            case Pending::Kind::operands: halve(next.operation, std::move(next.operands), next.met); break;
            case Pending::Kind::node: expand(next.node, next.met); break;
            }
        }
        return {std::move(program_), std::move(extents_)};
    }

private:
    static bool guarded(Operation operation) { return operation != Operation::set_union; }

    void open_guard() {
        guards_.push_back(program_.size());
        program_.push_back({Instruction::Kind::guard});
    }
    void combine(Operation operation) {
        program_.push_back({Instruction::Kind::combine, operation});
        if (!guarded(operation)) return;
        program_[guards_.back()].operand = std::uint32_t(program_.size());
        guards_.pop_back();
    }

    // Of a part that costs so much; returns the box that is met within the part.
    Box<double> open_extent(const Box<double>& box, double cost, const Box<double>& met) {
        const double chance = half_area(intersected(box, met)) / half_area(met);
        if (!box.bounded() || !((1 - minimum(chance, 1.0)) * cost > least_gain)) return met;
        program_.push_back({Instruction::Kind::extent, {}, std::uint32_t(extents_.size())});
        open_extents_.push_back(extents_.size());
        extents_.push_back({box, 0});
        todo_.push_back({Pending::Kind::end_extent, 0, {}, {}, {}});
        return box;
    }
    void end_extent() {
        extents_[open_extents_.back()].end = std::uint32_t(program_.size());
        open_extents_.pop_back();
    }

    // What is pushed last is written first.
    void finish_with(Operation operation) { todo_.push_back({Pending::Kind::combine, 0, operation, {}, {}}); }
    void then_guard(Operation operation) {
        if (guarded(operation)) todo_.push_back({Pending::Kind::guard, 0, operation, {}, {}});
    }
    void then_node(std::uint32_t node, const Box<double>& met) {
        todo_.push_back({Pending::Kind::node, node, {}, {}, met});
    }
    void then_operands(Operation operation, std::vector<std::uint32_t> operands, const Box<double>& met) {
        todo_.push_back({Pending::Kind::operands, 0, operation, std::move(operands), met});
    }

    void expand(std::uint32_t index, Box<double> met) {
        const CompoundNode& node = nodes_[index];
        if (!node_extents_.empty()) met = open_extent(node_extents_[index].box, costs_[index], met);
        switch (node.operation) {
        case Operation::leaf: program_.push_back({Instruction::Kind::leaf, {}, node.solid}); break;
        case Operation::complement:
            todo_.push_back({Pending::Kind::complement, 0, {}, {}, {}});
            then_node(node.left, met);
            break;
        case Operation::difference: {
            std::vector<std::uint32_t> operands = difference_chain(nodes_, index);
            const std::uint32_t first = operands.front();
            operands.erase(operands.begin());
            finish_with(Operation::difference);
            then_operands(Operation::set_union, std::move(operands), met);
            then_guard(Operation::difference);
            then_node(first, met);
            break;
        }
        case Operation::set_union:
        case Operation::intersection: then_operands(node.operation, chain(nodes_, index), met); break;
        }
    }

    void halve(Operation operation, std::vector<std::uint32_t> operands, Box<double> met) {
        if (operands.size() == 1) {
            then_node(operands.front(), met);
            return;
        }
        if (!node_extents_.empty()) met = open_group(operation, operands, met);
        const auto middle = operands.begin() + std::ptrdiff_t(operands.size() / 2);
        finish_with(operation);
        then_operands(operation, {middle, operands.end()}, met);
        then_guard(operation);
        then_operands(operation, {operands.begin(), middle}, met);
    }
    Box<double> open_group(Operation operation, const std::vector<std::uint32_t>& operands,
                           const Box<double>& met) {
        Box<double> box = node_extents_[operands.front()].box;
        double cost = 0;
        for (const std::uint32_t operand : operands) {
            const Box<double>& next = node_extents_[operand].box;
            box = operation == Operation::intersection ? intersected(box, next) : united(box, next);
            cost += costs_[operand];
        }
        return open_extent(box, cost, met);
    }

    Nodes nodes_;
    std::span<const NodeExtent> node_extents_;
    std::vector<double> costs_;
    std::vector<Pending> todo_;
    std::vector<std::size_t> guards_; // instructions whose target is not known yet
    std::vector<std::size_t> open_extents_;
    Program program_;
    std::vector<PartExtent> extents_;
};

} // namespace

Program compile(std::span<const CompoundNode> nodes) {
    return Compiler(nodes, {}).compile(Box<double>::everything()).program;
}

CompiledProgram compile(std::span<const CompoundNode> nodes, std::span<const NodeExtent> extents,
                        const Box<double>& within) {
    return Compiler(nodes, extents).compile(within);
}

} // namespace rayscope
