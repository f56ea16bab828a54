#include "core/csg/program.hpp"

namespace rayscope {
namespace {

// What is still to be written: a node, operands that one operation joins, a guard, or the operation itself.
struct Pending {
    enum class Kind { node, operands, guard, combine, complement } kind;
    std::uint32_t node = 0;
    Operation operation = Operation::leaf;
    std::vector<std::uint32_t> operands;
};

using Nodes = std::span<const CompoundNode>;

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

class Compiler {
public:
    explicit Compiler(Nodes nodes) : nodes_(nodes) {}

    Program compile() {
        todo_.push_back({Pending::Kind::node, std::uint32_t(nodes_.size() - 1), {}, {}});
        while (!todo_.empty()) {
            Pending next = std::move(todo_.back());
            todo_.pop_back();
            switch (next.kind) {
            case Pending::Kind::guard: open_guard(); break;
            case Pending::Kind::combine: combine(next.operation); break;
            case Pending::Kind::complement: program_.push_back({Instruction::Kind::complement}); break;
            case Pending::Kind::operands: halve(next.operation, std::move(next.operands)); break;
            case Pending::Kind::node: expand(next.node); break;
            }
        }
        return std::move(program_);
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

    // What is pushed last is written first.
    void finish_with(Operation operation) { todo_.push_back({Pending::Kind::combine, 0, operation, {}}); }
    void then_guard(Operation operation) {
        if (guarded(operation)) todo_.push_back({Pending::Kind::guard, 0, operation, {}});
    }
    void then_node(std::uint32_t node) { todo_.push_back({Pending::Kind::node, node, {}, {}}); }
    void then_operands(Operation operation, std::vector<std::uint32_t> operands) {
        todo_.push_back({Pending::Kind::operands, 0, operation, std::move(operands)});
    }

    void expand(std::uint32_t index) {
        const CompoundNode& node = nodes_[index];
        switch (node.operation) {
        case Operation::leaf: program_.push_back({Instruction::Kind::leaf, {}, node.solid}); break;
        case Operation::complement:
            todo_.push_back({Pending::Kind::complement, 0, {}, {}});
            then_node(node.left);
            break;
        case Operation::difference: {
            std::vector<std::uint32_t> operands = difference_chain(nodes_, index);
            const std::uint32_t first = operands.front();
            operands.erase(operands.begin());
            finish_with(Operation::difference);
            then_operands(Operation::set_union, std::move(operands));
            then_guard(Operation::difference);
            then_node(first);
            break;
        }
        case Operation::set_union:
        case Operation::intersection: then_operands(node.operation, chain(nodes_, index)); break;
        }
    }

    void halve(Operation operation, std::vector<std::uint32_t> operands) {
        if (operands.size() == 1) {
            then_node(operands.front());
            return;
        }
        const auto middle = operands.begin() + std::ptrdiff_t(operands.size() / 2);
        finish_with(operation);
        then_operands(operation, {middle, operands.end()});
        then_guard(operation);
        then_operands(operation, {operands.begin(), middle});
    }

    Nodes nodes_;
    std::vector<Pending> todo_;
    std::vector<std::size_t> guards_; // instructions whose target is not known yet
    Program program_;
};

} // namespace

Program compile(std::span<const CompoundNode> nodes) { return Compiler(nodes).compile(); }

} // namespace rayscope
