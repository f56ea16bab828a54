#include "core/povray/compounds.hpp"

#include "core/povray/shapes.hpp"
#include "core/povray/words.hpp"
#include "core/scene/expand.hpp"

#include <algorithm>
#include <ranges>

namespace rayscope::povray {
namespace {

// A union is a merge: of two that overlap, the walls within are no boundaries.
const char* name_of(Operation operation) {
    switch (operation) {
    case Operation::set_union: return "merge";
    case Operation::intersection: return "intersection";
    default: return "difference";
    }
}

class CompoundText {
public:
    CompoundText(const Scene& scene, std::size_t index, const Frame& frame, Textures& textures)
        : scene_(scene),
          whole_(*scene.compounds[index].material),
          frame_(frame),
          textures_(textures),
          tree_(expand(scene, index)) {}

    // From the root down over a stack of its own, since a tree can be deeper than a call stack.
    std::string write(const std::string& modifiers) {
        const ExpandedNode& root = tree_[below_complements(tree_.size() - 1)];
        const std::string texture =
            root.operation == Operation::leaf ? texture_of(root) : textures_.use(whole_, whole_, true);
        Step first{tree_.size() - 1, 0, false, texture + modifiers, false};
        std::vector<Step> steps{std::move(first)};
        while (!steps.empty()) {
            Step step = std::move(steps.back());
            steps.pop_back();
            if (step.closes) {
                text_ += indent(step.depth) +
                         (step.modifiers.empty() ? "" : "  " + step.modifiers + "\n" + indent(step.depth)) +
                         "}\n";
                continue;
            }
            for (; tree_[step.node].operation == Operation::complement; step.node = tree_[step.node].left)
                step.inverted = !step.inverted;
            if (tree_[step.node].operation == Operation::leaf)
                write_leaf(step);
            else
                open(step, steps);
        }
        return std::move(text_);
    }

private:
    struct Step {
        std::size_t node = 0, depth = 0;
        bool inverted = false;
        std::string modifiers;
        bool closes = false;
    };

    [[nodiscard]] std::size_t below_complements(std::size_t node) const {
        while (tree_[node].operation == Operation::complement) node = tree_[node].left;
        return node;
    }

    static std::string indent(std::size_t depth) {
        constexpr std::size_t deepest = 12; // beyond, the blanks would outweigh the text
        return std::string(2 * std::min(depth, deepest), ' ');
    }

    static std::string with_inverse(const Step& step) {
        if (!step.inverted) return step.modifiers;
        return step.modifiers.empty() ? "inverse" : "inverse " + step.modifiers;
    }

    void open(const Step& step, std::vector<Step>& steps) {
        text_ += indent(step.depth) + name_of(tree_[step.node].operation) + " {\n";
        Step close = step;
        close.closes = true;
        close.modifiers = with_inverse(step);
        steps.push_back(std::move(close));
        const std::vector<std::size_t> operands = chain(step.node);
        for (const std::size_t operand : std::views::reverse(operands))
            steps.push_back({operand, step.depth + 1, false, "", false});
    }

    // A − B − C is one difference of three, and the same for unions and intersections: short to read, and shallow.
    [[nodiscard]] std::vector<std::size_t> chain(std::size_t node) const {
        std::vector<std::size_t> operands;
        const Operation operation = tree_[node].operation;
        for (; tree_[node].operation == operation; node = tree_[node].left)
            operands.push_back(tree_[node].right);
        operands.push_back(node);
        std::reverse(operands.begin(), operands.end());
        return operands;
    }

    [[nodiscard]] std::size_t wall_of(const ExpandedNode& leaf) const {
        return leaf.material.value_or(whole_);
    }
    [[nodiscard]] std::string texture_of(const ExpandedNode& leaf) {
        return textures_.use(whole_, wall_of(leaf), true, frame_.matrix(leaf.matrix));
    }

    void write_leaf(const Step& step) {
        const ExpandedNode& leaf = tree_[step.node];
        const SceneGeneric& generic = scene_.generics[leaf.generic];
        std::string modifiers = with_inverse(step);
        // Walls that look like the whole inherit its texture; patterns lie in each operand's own space.
        const bool looks_different = wall_of(leaf) != whole_ || textures_.shows_patterns(whole_, whole_);
        if (looks_different && step.modifiers.empty())
            modifiers += (modifiers.empty() ? "" : " ") + texture_of(leaf);
        text_ += indent(step.depth) + comment(generic.name);
        text_ += indent(step.depth) + shape(generic.shape, frame_.matrix(leaf.matrix), modifiers);
    }

    const Scene& scene_;
    std::size_t whole_; // the material of the compound
    const Frame& frame_;
    Textures& textures_;
    std::vector<ExpandedNode> tree_;
    std::string text_;
};

} // namespace

std::string compound(const Scene& scene, std::size_t index, const Frame& frame, Textures& textures,
                     const std::string& modifiers) {
    return CompoundText(scene, index, frame, textures).write(modifiers);
}

} // namespace rayscope::povray
