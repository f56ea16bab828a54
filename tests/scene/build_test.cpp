#include "core/scene/build.hpp"
#include "core/scene/expand.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

std::vector<double> ends(const Spans<double>& spans) {
    std::vector<double> result;
    for (const Span<double>& s : spans) {
        result.push_back(s.enter.t);
        result.push_back(s.exit.t);
    }
    return result;
}

TEST(Expand, a_compound_in_a_compound_equals_the_same_written_flat) {
    Random random(7);
    const Mat4d inner = translation({0.25, 0, 0}) * rotation({0, 0, 1}, 90),
                outer = translation({0, 0, 3}) * scaling(2);
    SceneBuilder nested, flat;
    for (SceneBuilder* b : {&nested, &flat}) {
        const auto m = b->glowing({1, 1, 1});
        const bool is_flat = b == &flat;
        b->operand("a", Cube<double>{}, (is_flat ? outer * inner : Mat4d{1}) * scaling(1, 0.5, 1));
        b->operand("s", Sphere<double>{}, (is_flat ? outer * inner : Mat4d{1}) * scaling(0.75));
        b->operand("p", Cylinder<double>{}, is_flat ? outer : Mat4d{1});
        if (is_flat) {
            b->compound("whole", "p - (a | s)", m);
        } else {
            b->compound("part", "a | s", std::nullopt, inner);
            b->compound("whole", "p - part", m, outer);
        }
    }
    const Workbench one = nested.open(), other = flat.open();
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray<double> ray{random.in_cube(6), random.direction()};
        const auto a = spans(one, ray)[0], b = spans(other, ray)[0];
        ASSERT_EQ(ends(a), ends(b)) << hex(ray);
        hits += int(a.size());
    }
    EXPECT_GT(hits, 50);
}

TEST(Expand, operands_come_before_operations_with_the_product_of_the_matrices) {
    SceneBuilder b;
    b.operand("a", Cube<double>{}, scaling(3));
    b.operand("b", Cube<double>{});
    b.compound("in", "a - b", std::nullopt, translation({1, 0, 0}));
    b.compound("out", "!in & b", std::nullopt, scaling(2));
    const auto tree = expand(b.scene(), 1);
    ASSERT_EQ(tree.size(), 6U);
    EXPECT_EQ(tree[0].generic, 0U);
    EXPECT_EQ(tree[0].matrix, scaling(2) * translation({1, 0, 0}) * scaling(3));
    EXPECT_EQ(tree[1].generic, 1U);
    EXPECT_EQ(tree[2].operation, Operation::difference);
    EXPECT_EQ(tree[2].left, 0U);
    EXPECT_EQ(tree[2].right, 1U);
    EXPECT_EQ(tree[2].compound, 0U);
    EXPECT_EQ(tree[3].operation, Operation::complement);
    EXPECT_EQ(tree[3].left, 2U);
    EXPECT_EQ(tree[4].matrix, scaling(2));
    EXPECT_EQ(tree[5].operation, Operation::intersection);
    EXPECT_EQ(tree[5].left, 3U);
    EXPECT_EQ(tree[5].right, 4U);
    EXPECT_EQ(tree[5].compound, 1U);
}

TEST(Expand, sub_expressions_that_double_are_refused_before_they_fill_the_memory) {
    SceneBuilder b;
    b.operand("c0", Cube<double>{});
    for (int i = 1; i <= 60; ++i) {
        const std::string before = "c" + std::to_string(i - 1);
        b.compound("c" + std::to_string(i), before + " | " + before);
    }
    b.scene().compounds.back().material = b.glowing({1, 1, 1});
    b.scene().drawn.push_back({true, 59});
    try {
        (void)b.open();
        FAIL() << "2⁶⁰ nodes were accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("more than 4194304 nodes"), std::string::npos)
            << error.what();
    }
}

void expect_refused(SceneBuilder& b, const std::string& part) {
    try {
        (void)b.open();
        ADD_FAILURE() << "accepted";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(Build, what_is_drawn_needs_a_material) {
    SceneBuilder b;
    b.operand("ball", Sphere<double>{});
    b.scene().drawn.push_back({false, 0});
    expect_refused(b, "generic 'ball' is drawn and has no material");
    SceneBuilder c;
    c.operand("ball", Sphere<double>{});
    c.compound("thing", "ball");
    c.scene().drawn.push_back({true, 0});
    expect_refused(c, "compound 'thing' is drawn and has no material");
}

TEST(Build, matrices_that_multiply_to_a_singular_one_are_refused) {
    SceneBuilder b;
    b.operand("ball", Sphere<double>{}, scaling(1e-300));
    b.compound("thing", "ball", b.glowing({1, 1, 1}), scaling(1e-300));
    expect_refused(b, "'thing' and of its operand 'ball' multiply to one that can't be inverted");
}

TEST(Build, boxes_hold_what_can_be_hit) {
    SceneBuilder b;
    const auto m = b.glowing({1, 1, 1});
    b.operand("a", Cube<double>{});
    b.operand("b", Cube<double>{}, translation({1.5, 0, 0}));
    b.operand("p", Plane<double>{});
    b.compound("both", "a | b", m);
    b.compound("common", "a & b", m);
    b.compound("less", "a - b", m);
    b.compound("not", "!a", m);
    b.compound("half", "p", m);
    b.compound("cut", "a & p", m);
    const auto& objects = b.open().world.objects;
    const auto expect_x = [&](std::size_t object, double low, double high) {
        EXPECT_NEAR(objects[object].bounds.low.x, low, 1e-14);
        EXPECT_NEAR(objects[object].bounds.high.x, high, 1e-14);
        EXPECT_LE(objects[object].bounds.low.x, low);
        EXPECT_GE(objects[object].bounds.high.x, high);
    };
    expect_x(0, -1, 2.5);
    expect_x(1, 0.5, 1);
    expect_x(2, -1, 1);
    EXPECT_FALSE(objects[3].bounds.bounded());
    EXPECT_FALSE(objects[4].bounds.bounded());
    expect_x(5, -1, 1);
    for (std::uint64_t seed = 1; seed <= 300; ++seed) { // turned boxes
        Random random(seed);
        SceneBuilder c;
        c.generic(Cone<double>{}, random_matrix(random), c.glowing({1, 1, 1}));
        const Workbench bench = c.open();
        const Ray<double> ray{random.in_cube(6), random.direction()};
        const auto lists = spans(bench, ray);
        for (const Span<double>& s : lists[0])
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_GE(ray.at(s.enter.t)[axis], bench.world.objects[0].bounds.low[axis] - 1e-13) << seed;
                ASSERT_LE(ray.at(s.enter.t)[axis], bench.world.objects[0].bounds.high[axis] + 1e-13) << seed;
            }
    }
}

TEST(Build, an_operand_with_a_material_of_its_own_keeps_it_for_its_walls) {
    SceneBuilder b;
    const auto red = b.glowing({1, 0, 0}), blue = b.glowing({0, 0, 1});
    b.operand("block", Cube<double>{});
    b.operand("bore", Cylinder<double>{}, scaling(0.5, 0.5, 2));
    b.scene().generics.back().material = blue;
    b.compound("drilled", "block - bore", red);
    const Workbench bench = b.open();
    EXPECT_EQ(trace_ray(bench, {{-3, 0, 0}, {1, 0, 0}}).colour, (Colour{1, 0, 0}));
    EXPECT_EQ(trace_ray(bench, {{0, 0, 0}, {1, 0, 0}}).colour, (Colour{0, 0, 1}));
}

TEST(NameTrace, nodes_are_called_as_the_author_did) {
    SceneBuilder b;
    const auto m = b.clear(0, 1, 1.5);
    b.scene().materials[m].name = "glass";
    b.generic(Plane<double>{}, translation({0, 0, -9}), b.glowing({1, 1, 1})); // unnamed, and first
    b.operand("outer", Sphere<double>{}, scaling(2));
    b.operand("inner", Sphere<double>{});
    b.operand("mouth", Cube<double>{});
    b.compound("shell", "outer - inner");
    b.compound("bowl", "(shell | mouth) - (inner & !mouth)", m);
    const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}});
    ASSERT_EQ(trace.objects.size(), 2U);
    const std::size_t bowl = trace.objects[0].name == "bowl" ? 0 : 1;
    EXPECT_EQ(trace.objects[1 - bowl].name, "plane #0");
    const TraceObject& object = trace.objects[bowl];
    EXPECT_EQ(object.name, "bowl");
    EXPECT_EQ(object.material, "glass");
    std::vector<std::string> names;
    for (const TraceNode& node : object.nodes) names.push_back(node.name);
    EXPECT_EQ(names,
              (std::vector<std::string>{"outer", "inner", "shell", "mouth", "shell ∪ mouth", "inner", "mouth",
                                        "¬mouth", "inner ∩ ¬mouth", "(shell ∪ mouth) − (inner ∩ ¬mouth)"}));
    ASSERT_EQ(trace.media.size(), 2U);
    EXPECT_EQ(trace.media[0].name, "air");
    EXPECT_EQ(trace.media[1].name, "bowl");
    EXPECT_DOUBLE_EQ(trace.media[1].speed, 1 / 1.5);
    const auto* hit = trace.rays[0].find<BoundaryChosen>();
    ASSERT_NE(hit, nullptr);
    EXPECT_EQ(trace.objects[std::size_t(hit->object)].name, "bowl");
    EXPECT_EQ(trace.generics[std::size_t(hit->boundary.leaf)], "outer");
    EXPECT_EQ(hit->medium_from, 0);
    EXPECT_EQ(hit->medium_to, 1);
}

TEST(NameTrace, what_no_event_names_is_left_out_and_surroundings_are_called_so) {
    SceneBuilder b;
    const auto m = b.glowing({1, 1, 1});
    for (int i = 0; i < 100; ++i) b.generic(Sphere<double>{}, translation({0, 10.0 * i, 0}), m);
    b.scene().medium_speed = 0.75;
    const Trace trace = trace_ray(b.open(), {{0, 500, 5}, {0, 0, -1}});
    ASSERT_EQ(trace.objects.size(), 1U);
    EXPECT_EQ(trace.objects[0].name, "sphere #50");
    EXPECT_EQ(trace.media[0].name, "surroundings");
    EXPECT_EQ(trace.media[0].speed, 0.75);
}

TEST(NameTrace, long_expressions_are_cut) {
    SceneBuilder b;
    std::string text = "operand";
    b.operand("operand", Cube<double>{});
    for (int i = 0; i < 1000; ++i) text += " | operand";
    b.compound("chain", text, b.glowing({1, 1, 1}));
    const Trace trace = trace_ray(b.open(), {{0, 0, 5}, {0, 0, -1}});
    for (const TraceNode& node : trace.objects.at(0).nodes) {
        ASSERT_LT(node.name.size(), 100U) << node.name;
    }
}

} // namespace
} // namespace rayscope::test
