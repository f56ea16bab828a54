#include "core/csg/program.hpp"

namespace rayscope {
namespace {

// A range of operands that one operation joins, still to be written; or a finished instruction.
struct Pending {
    enum class Kind { node, operands, instruction } kind;
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
    for (; nodes[at].operation == Operation::difference; at = nodes[at].left) operands.push_back(nodes[at].right);
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
            case Pending::Kind::instruction: program_.push_back({next.operation, 0}); break;
            case Pending::Kind::operands: halve(next.operation, std::move(next.operands)); break;
            case Pending::Kind::node: expand(next.node); break;
            }
        }
        return std::move(program_);
    }

  private:
    // What is pushed last is written first.
    void finish_with(Operation operation) { todo_.push_back({Pending::Kind::instruction, 0, operation, {}}); }
    void then_node(std::uint32_t node) { todo_.push_back({Pending::Kind::node, node, {}, {}}); }
    void then_operands(Operation operation, std::vector<std::uint32_t> operands) {
        todo_.push_back({Pending::Kind::operands, 0, operation, std::move(operands)});
    }

    void expand(std::uint32_t index) {
        const CompoundNode& node = nodes_[index];
        switch (node.operation) {
        case Operation::leaf: program_.push_back({Operation::leaf, node.solid}); break;
        case Operation::complement:
            finish_with(Operation::complement);
            then_node(node.left);
            break;
        case Operation::difference: {
            std::vector<std::uint32_t> operands = difference_chain(nodes_, index);
            const std::uint32_t first = operands.front();
            operands.erase(operands.begin());
            finish_with(Operation::difference);
            then_operands(Operation::set_union, std::move(operands));
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
        then_operands(operation, {operands.begin(), middle});
    }

    Nodes nodes_;
    std::vector<Pending> todo_;
    Program program_;
};

} // namespace

Program compile(std::span<const CompoundNode> nodes) { return Compiler(nodes).compile(); }

} // namespace rayscope
