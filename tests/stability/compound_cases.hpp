#pragma once
// Compounds and a ray, drawn by RapidCheck so that what fails shrinks to few operands and plain matrices.

#include "tests/stability/draw_case.hpp"
#include "tests/support/scenes.hpp"

#include <rapidcheck.h>

namespace rayscope::test {

struct Operand {
    Generic<double> shape;
    Mat4d matrix{1};
};

struct CompoundCase {
    std::string expression; ///< of operands a, b, …
    std::vector<Operand> operands;
    Ray<double> ray;
};

/// A line of compound_corpus.inc.
[[nodiscard]] inline std::string line_of(const CompoundCase& c) {
    std::string line = "{\"" + c.expression + "\", {";
    for (const Operand& o : c.operands)
        line.append("{").append(shape_text(o.shape)).append(", ").append(hex(o.matrix)).append("}, ");
    return line.append("}, ").append(hex(c.ray)).append("},");
}

[[nodiscard]] inline std::vector<CompoundCase> compound_corpus() {
    return {
#include "tests/stability/compound_corpus.inc"
    };
}

[[nodiscard]] inline Workbench workbench_of(const CompoundCase& c) {
    SceneBuilder b;
    for (std::size_t i = 0; i < c.operands.size(); ++i)
        b.operand({char('a' + i)}, c.operands[i].shape, c.operands[i].matrix);
    b.compound("c", c.expression, b.glowing({1, 1, 1}));
    return b.open();
}

/// Any numbers are an expression in postfix order: below `operands` an operand, else an operation on what lies on the
/// stack, if that is enough; what is left in the end is united. So a list that RapidCheck shortens is one, too.
[[nodiscard]] inline std::string expression_of(const std::vector<int>& steps, int operands) {
    std::vector<std::string> stack;
    for (const int step : steps) {
        if (step < operands) {
            stack.push_back({char('a' + step)});
        } else if (const int operation = (step - operands) % 4; operation == 3) {
            if (!stack.empty()) stack.back() = "!(" + stack.back() + ")";
        } else if (stack.size() > 1) {
            const std::string right = stack.back();
            stack.pop_back();
            stack.back() = "(" + stack.back() + " " + "|&-"[operation] + " " + right + ")";
        }
    }
    if (stack.empty()) return "a";
    std::string all = stack.front();
    for (std::size_t i = 1; i < stack.size(); ++i) all += " | " + stack[i];
    return all;
}

/// 0: none; up to 8: moves and scales after which faces are flush; beyond: by chance, of one size.
[[nodiscard]] inline Mat4d operand_matrix(int number) {
    switch (number) {
    case 0: return Mat4d{1};
    case 1: return translation({1, 0, 0});
    case 2: return scaling(0.5);
    case 3: return translation({0, 0, 2});
    case 4: return scaling(0.5, 0.5, 1);
    case 5: return scaling(1, 1, -1);
    case 6: return translation({0, 0, 1}) * scaling(1, 1, 2);
    case 7: return rotation({0, 0, 1}, 45);
    case 8: return rotation(normalized(Vec3d{1, 1, 1}), 120); // rounded: nearly a permutation of the axes
    default: {
        Random random{std::uint64_t(number)};
        return random_matrix(random);
    }
    }
}

/// Operands all moved by one matrix, of any size and place: flush faces stay flush up to its rounding.
[[nodiscard]] inline CompoundCase draw_compound() {
    const auto shapes = solid_generics();
    const int operands = *rc::gen::inRange(1, 7);
    const Mat4d whole = *rc::gen::inRange(0, 3) == 0 ? Mat4d{1} : [] {
        Random random{*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())};
        return draw_matrix(random);
    }();
    CompoundCase c;
    for (int i = 0; i < operands; ++i) {
        const auto kind = std::size_t(*rc::gen::inRange(0, int(shapes.size())));
        const int number = *rc::gen::inRange(0, 20);
        c.operands.push_back({shapes[kind], whole * operand_matrix(number)});
    }
    c.expression =
        expression_of(*rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 2 * operands + 4)), operands);
    Random random{*rc::gen::noShrink(rc::gen::arbitrary<std::uint64_t>())};
    const Ray<double> ray = draw_object_ray(random);
    c.ray = {transformed_point(whole, ray.origin), normalized(transformed_vector(whole, ray.direction))};
    return c;
}

} // namespace rayscope::test
