// Guards against holes and slivers: a ray that gets in and never out, pieces of a compound that are lost, and skins
// that nobody built.

#include "core/extents/scan.hpp"
#include "core/scene/build.hpp"
#include "tests/stability/compound_cases.hpp"
#include "tests/stability/ends.hpp"
#include "tests/stability/property.hpp"

namespace rayscope::test {
namespace {

// From inside a bounded solid every ray comes out once more than in; the first thing that it meets is a way out.
Verdict judge_leaving(const Case& c) {
    const WideRay exact = exact_object_ray(c.matrix, c.ray);
    if (!is_solid(c.shape) || !exactly_inside(c.shape, exact.origin)) return {"", false};
    SceneBuilder b;
    b.generic(c.shape, c.matrix, b.glowing({1, 1, 1}));
    const World<double> world = build(b.scene());
    Work<double> work;
    NullRecorder recorder;
    const auto hit = Scan<double>(world).closest(c.ray, Range<double>{}, Leaving<double>{}, work, recorder);
    const auto crossings = exact_crossings(c.shape, exact);
    const bool endless = crossings.empty() || crossings.back().entering || crossings.back().t <= 0;
    if (endless) return {hit ? "a way out of what has none, at " + hex((*hit).t) : ""};
    const auto way_out =
        std::find_if(crossings.begin(), crossings.end(), [](const auto& e) { return e.t > 0; });
    // So close to the surface that rounding may have put the start outside.
    if (double(way_out->t) <= 2 * world.solids[0].error_bound(c.ray, double(way_out->t), way_out->face))
        return {"", false};
    if (way_out != crossings.begin())
        if (const auto in = way_out - 1;
            -double(in->t) <= 2 * world.solids[0].error_bound(c.ray, double(in->t), in->face))
            return {"", false};
    if (!hit) return {"never leaves"};
    if ((*hit).entering) return {"enters, from inside, at " + hex((*hit).t)};
    return {};
}

Case draw_inside(const Generic<double>& shape, Random& random) {
    Case c{shape, draw_matrix(random), {}};
    for (int tries = 0; tries < 100; ++tries) {
        const Vec3d p = random.in_cube(1.7);
        if (implicit_value(shape, p) > -random.decade(-12, 0)) continue;
        c.ray = {transformed_point(c.matrix, p), random.direction()};
        return c;
    }
    c.ray = {transformed_point(c.matrix, Vec3d{1, 0, 0}), random.direction()};
    return c;
}

void expect_to_leave(int cases) {
    for (const Generic<double>& shape : solid_generics())
        expect_of_cases(
            generic_name(shape), cases, 0.8, [&](Random& random) { return draw_inside(shape, random); },
            judge_leaving);
}

TEST(Closedness, a_ray_from_inside_leaves) { expect_to_leave(samples(3000)); }
TEST(ClosednessFull, a_ray_from_inside_leaves) { expect_to_leave(samples(300000)); }

bool tree_holds(const Compound& compound, const std::vector<bool>& leaves) {
    std::vector<bool> inside;
    for (const CompoundNode& node : compound.nodes) {
        if (node.operation == Operation::leaf)
            inside.push_back(leaves[node.solid]);
        else if (node.operation == Operation::complement)
            inside.push_back(!inside[node.left]);
        else
            inside.push_back(holds(node.operation, inside[node.left], inside[node.right]));
    }
    return inside.back();
}

// The operand of each solid of the world: the leaves in the order of the tree.
std::vector<std::size_t> operands_of(const CompoundCase& c) {
    std::vector<std::size_t> operands;
    for (const ExpressionNode& node : parse_expression(c.expression))
        if (node.operation == Operation::leaf) operands.push_back(std::size_t(node.name[0] - 'a'));
    return operands;
}

bool list_holds(const Spans<double>& list, double t) {
    return std::any_of(list.begin(), list.end(),
                       [&](const auto& s) { return s.enter.t < t && t < s.exit.t; });
}

// Between any two crossings of any operands, further apart than rounding could put them, the point is asked: in 113 bits
// every operand, and the tree of what they say.
Verdict judge_compound(const CompoundCase& c) {
    const Workbench bench = workbench_of(c);
    const auto operands = operands_of(c);
    std::vector<WideRay> rays;
    std::vector<End> cuts;
    for (std::size_t i = 0; i < operands.size(); ++i) {
        const Operand& operand = c.operands[operands[i]];
        const Case leaf{operand.shape, operand.matrix, c.ray};
        if (runs_in_a_face(leaf)) return {"", false};
        rays.push_back(exact_object_ray(operand.matrix, c.ray));
        for (const ExactCrossing& e : exact_crossings(operand.shape, rays.back()))
            cuts.push_back(end_of(bench.world.solids[i], c.ray, double(e.t), e.face));
        // A graze may be seen where there is none.
        for (const Interval<double>& span : bench.world.solids[i].intervals(c.ray))
            for (const auto& [t, face] :
                 {std::pair{span.enter, span.enter_face}, std::pair{span.exit, span.exit_face}})
                if (std::isfinite(t)) cuts.push_back(end_of(bench.world.solids[i], c.ray, t, face));
    }
    for (const End& cut : cuts)
        if (!std::isfinite(cut.bound)) return {"", false};
    std::sort(cuts.begin(), cuts.end(), [](const End& a, const End& b) { return a.t < b.t; });
    const double far = cuts.empty() ? 1 : 2 * (cuts.back().t - cuts.front().t) + std::abs(cuts.front().t) + 1;
    cuts.insert(cuts.begin(), {cuts.empty() ? -far : cuts.front().t - far, 0});
    cuts.push_back({cuts.back().t + far, 0});
    const Spans<double> list = spans(bench, c.ray)[0];
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double width = cuts[i + 1].t - cuts[i].t;
        if (!(width > 2 * (cuts[i].bound + cuts[i + 1].bound))) continue;
        const double t = cuts[i].t + 0.625 * width;
        std::vector<bool> leaves;
        for (std::size_t k = 0; k < operands.size(); ++k)
            leaves.push_back(exactly_inside(c.operands[operands[k]].shape, rays[k].at(Wide(t))));
        const bool truth = tree_holds(bench.world.compounds[0], leaves);
        if (list_holds(list, t) != truth)
            return {std::string(truth ? "not inside" : "inside") + " at " + hex(t)};
    }
    for (std::size_t i = 0; i < list.size(); ++i)
        if (!(list[i].enter.t < list[i].exit.t) || (i > 0 && !(list[i - 1].exit.t < list[i].enter.t)))
            return {"spans that touch at " + hex(list[i].enter.t)};
    return {};
}

void expect_true_spans(int cases) {
    for (const CompoundCase& c : compound_corpus())
        if (const Verdict verdict = judge_compound(c); !verdict.wrong.empty())
            ADD_FAILURE() << verdict.wrong << "\nof the corpus: " << line_of(c);
    int decided = 0, asked = 0;
    expect_property("spans", cases, [&] {
        const CompoundCase c = draw_compound();
        const Verdict verdict = judge_compound(c);
        ++asked;
        decided += verdict.decided ? 1 : 0;
        if (!verdict.wrong.empty()) RC_FAIL(verdict.wrong + '\n' + line_of(c));
    });
    EXPECT_GE(decided, asked / 2);
}

TEST(Closedness, spans_of_a_compound_are_where_its_tree_holds) { expect_true_spans(samples(3000)); }
TEST(ClosednessFull, spans_of_a_compound_are_where_its_tree_holds) { expect_true_spans(samples(200000)); }

} // namespace
} // namespace rayscope::test
