// Compounds of real solids, through the public face.

#include "tests/support/effort.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

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

std::string random_expression(Random& random, int leaves) {
    const std::string sign = random.below(5) == 0 ? "!" : "";
    if (leaves == 1) return sign + char('a' + random.below(6));
    const int left = 1 + random.below(leaves - 1);
    return sign + '(' + random_expression(random, left) + "|&-"[random.below(3)] +
           random_expression(random, leaves - left) + ')';
}

bool tree_contains(const Workbench& bench, const Vec3d& p, double& nearest) {
    const Compound& compound = bench.world.compounds[0];
    std::vector<bool> inside;
    nearest = infinity<double>;
    for (const CompoundNode& node : compound.nodes) {
        if (node.operation == Operation::leaf) {
            const Solid<double>& solid = bench.world.solids[node.solid];
            const double value = implicit_value(solid.shape, solid.transform.point_to_object(p));
            nearest = std::min(nearest, std::abs(value));
            inside.push_back(value < 0);
        } else {
            const bool a = inside[node.left];
            inside.push_back(
                node.operation == Operation::complement ? !a : holds(node.operation, a, inside[node.right]));
        }
    }
    return inside.back();
}

TEST(Compound, is_inside_where_the_tree_of_implicit_values_is) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(400)); ++seed) {
        Random random(seed);
        SceneBuilder b;
        const auto shapes = solid_generics();
        for (char name = 'a'; name <= 'f'; ++name)
            b.operand({name}, shapes[std::size_t(random.below(int(shapes.size())))], random_matrix(random));
        const std::string expression = random_expression(random, 1 + random.below(7));
        b.compound("c", expression, b.glowing({1, 1, 1}));
        const Workbench bench = b.open();
        for (int i = 0; i < 20; ++i) {
            const Ray<double> ray{random.in_cube(6), random.direction()};
            const Spans<double> list = spans(bench, ray)[0];
            std::vector<double> cuts{-infinity<double>};
            for (const double t : ends(list))
                if (std::isfinite(t)) cuts.push_back(t);
            cuts.front() = cuts.size() > 1 ? cuts[1] - 30 : -30;
            cuts.push_back(cuts.back() + 30);
            bool inside = !list.empty() && list[0].enter.t == -infinity<double>;
            for (std::size_t k = 0; k + 1 < cuts.size(); ++k, inside = !inside)
                for (const double part : {0.1, 0.35, 0.5, 0.75}) {
                    double nearest = 0;
                    const double t = cuts[k] + part * (cuts[k + 1] - cuts[k]);
                    const bool truth = tree_contains(bench, ray.at(t), nearest);
                    if (nearest > 1e-7) {
                        ASSERT_EQ(truth, inside)
                            << expression << hex(ray) << " t " << hex(t) << " seed " << seed;
                    }
                }
        }
    }
}

TEST(Compound, a_solid_without_itself_is_empty_and_with_its_complement_everything) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        Random random(seed);
        for (const Generic<double>& shape : solid_generics()) {
            SceneBuilder b;
            b.operand("a", shape, random_matrix(random));
            const auto m = b.glowing({1, 1, 1});
            b.compound("nothing", "a - a", m);
            b.compound("everything", "a | !a", m);
            b.compound("itself", "a | a & a", m);
            b.compound("alone", "a", m);
            const auto lists = spans(b.open(), {random.in_cube(4), random.direction()});
            ASSERT_TRUE(lists[0].empty()) << generic_name(shape) << seed;
            ASSERT_EQ(ends(lists[1]), (std::vector<double>{-infinity<double>, infinity<double>})) << seed;
            ASSERT_EQ(ends(lists[2]), ends(lists[3])) << seed;
        }
    }
}

// Three bores whose caps are flush with the drilled cylinder's, at any place and size: one by one, or all at once, and
// in any order there are no slivers; what is left is as thick as the cylinder.
TEST(Compound, flush_caps_leave_no_slivers) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(samples(300)); ++seed) {
        Random random(seed);
        const double size = random.decade(-6, 6);
        const Mat4d place = translation(size * random.in_cube(10)) * random_rotation(random) * scaling(size);
        SceneBuilder b;
        b.operand("d", Cylinder<double>{}, place);
        for (int i = 0; i < 3; ++i) {
            const Vec3d at{0.5 * std::cos(2.1 * i), 0.5 * std::sin(2.1 * i), 0};
            // The bore's matrix is made another way, so that its caps are flush only within rounding.
            b.operand({char('a' + i)}, Cylinder<double>{},
                      place * (rotation({0, 0, 1}, random.uniform(0, 360)) * translation(at) *
                               scaling(0.2, 0.2, 1)));
        }
        const auto m = b.glowing({1, 1, 1});
        b.compound("chain", "d - a - b - c", m);
        b.compound("together", "d - (a | b | c)", m);
        b.compound("met", "d & !a & !b & !c", m);
        const Workbench bench = b.open();
        for (int i = 0; i < 50; ++i) {
            const Vec3d local{random.uniform(-1.1, 1.1), random.uniform(-1.1, 1.1), 3};
            const Vec3d from = transformed_point(place, local);
            const Vec3d to = transformed_point(place, Vec3d{0.9 * local.x, 0.9 * local.y, -1} +
                                                          random.uniform(0, 1.2) * random.direction());
            const Ray<double> ray{from, normalized(to - from)};
            const auto lists = spans(bench, ray);
            const std::string what = hex(ray) + " seed " + std::to_string(seed);
            ASSERT_EQ(ends(lists[0]), ends(lists[1])) << what;
            ASSERT_EQ(ends(lists[0]), ends(lists[2])) << what;
            for (std::size_t k = 0; k < lists[0].size(); ++k) {
                const Span<double>& s = lists[0][k];
                const Solid<double>& one = bench.world.solids[s.enter.surface.solid];
                const Solid<double>& two = bench.world.solids[s.exit.surface.solid];
                const double bound = one.error_bound(ray, s.enter.t, s.enter.surface.face) +
                                     two.error_bound(ray, s.exit.t, s.exit.surface.face);
                ASSERT_GT(s.exit.t - s.enter.t, bound) << what;
            }
        }
        // Straight down the middle of a bore: nothing at all.
        const Vec3d down = normalized(transformed_vector(place, {0, 0, -1}));
        const Solid<double>& bore = bench.world.solids[1];
        const Vec3d middle = bore.transform.translation() - 5 * size * down;
        const auto lists = spans(bench, {middle, down});
        for (int k = 0; k < 3; ++k) {
            ASSERT_TRUE(lists[std::size_t(k)].empty()) << k << " seed " << seed;
        }
    }
}

TEST(Compound, the_bore_of_a_drilled_block_shows_the_bores_wall_turned_around) {
    SceneBuilder b;
    b.operand("block", Cube<double>{});
    b.operand("bore", Cylinder<double>{}, scaling(0.5, 0.5, 2));
    b.compound("drilled", "block - bore", b.glowing({1, 1, 1}));
    const Workbench bench = b.open();
    const Ray<double> ray{{-3, 0, 0}, {1, 0, 0}};
    const auto list = spans(bench, ray)[0];
    EXPECT_EQ(ends(list), (std::vector<double>{2, 2.5, 3.5, 4}));
    EXPECT_TRUE(list[0].exit.surface.flipped && list[1].enter.surface.flipped);
    EXPECT_FALSE(list[0].enter.surface.flipped || list[1].exit.surface.flipped);
    const Trace trace = trace_ray(bench, {{0, 0, 0}, {1, 0, 0}}); // from within the bore
    const auto* hit = trace.rays[0].find<BoundaryChosen>();
    ASSERT_NE(hit, nullptr);
    EXPECT_EQ(hit->boundary.t, 0.5);
    EXPECT_TRUE(hit->entering);
    EXPECT_EQ(hit->normal, (Vec3d{-1, 0, 0})); // out of the material, into the bore
}

TEST(Compound, a_ray_through_a_hundred_thousand_spans) {
    SceneBuilder b;
    constexpr std::size_t count = 100000;
    const auto m = b.glowing({1, 1, 1});
    SceneCompound c;
    c.name = "beads";
    for (std::size_t i = 0; i < count; ++i) {
        b.operand("bead", Sphere<double>{}, translation({4.0 * double(i), 0, 0}));
        SceneNode leaf;
        leaf.operand = i;
        c.nodes.push_back(leaf);
        if (i == 0) continue;
        SceneNode join;
        join.operation = Operation::set_union;
        join.left = c.nodes.size() - 2;
        join.right = c.nodes.size() - 1;
        c.nodes.push_back(join);
    }
    c.material = m;
    b.scene().compounds.push_back(c);
    b.scene().drawn.push_back({true, 0});
    const auto list = spans(b.open(), {{-5, 0, 0}, {1, 0, 0}})[0];
    ASSERT_EQ(list.size(), count);
    EXPECT_EQ(list.back().exit.t, 4.0 * double(count - 1) + 6);
}

} // namespace
} // namespace rayscope::test
