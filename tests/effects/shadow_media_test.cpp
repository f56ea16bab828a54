// Guards against light that gets through a stack of media in one way for the eye and in another for a shadow ray.

#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

/// Slabs across the z axis over a matt floor, below a sun that stands straight above; a white sky.
class Stack {
public:
    Stack() {
        b_.scene().limits.min_weight = 0;
        b_.scene().limits.max_depth = 16;
        b_.scene().background = Colour{1};
        b_.scene().ambient = Colour{0};
        b_.sun({0, 0, 1});
        SceneMaterial matt = SceneBuilder::dark();
        matt.diffuse = Colour{1};
        b_.generic(Plane<double>{}, translation({0, 0, -10}), b_.material(matt), "floor");
    }
    Stack& slab(double low, double high, const SceneMaterial& material, int priority = 0) {
        b_.generic(Cube<double>{}, translation({0, 0, (low + high) / 2}) * scaling(50, 50, (high - low) / 2),
                   b_.material(material), "slab", priority);
        return *this;
    }
    Stack& by_the_notes() {
        b_.scene().notes_media = true;
        return *this;
    }

    /// The share of the sun that the floor sees.
    [[nodiscard]] Colour in_light() const {
        return trace_ray(b_.open(), {{0.1, 0.2, -9.5}, {0, 0, -1}}).rays[0].find<LightLit>()->visibility;
    }
    /// The share of the sky that comes straight through to an eye on the floor.
    [[nodiscard]] Colour in_view() const {
        Colour weight{1};
        const Trace trace = trace_ray(b_.open(), {{0.1, 0.2, -9.5}, {0, 0, 1}});
        for (const TracedRay& ray : trace.rays) {
            const RaySpawned& start = ray.start();
            const bool straight = start.kind == RayKind::refracted && start.direction.z > 0;
            const bool direct =
                ray.parent == none || trace.rays[std::size_t(ray.parent)].start().direction.z > 0;
            if (straight && direct && ray.find<Missed>() != nullptr) weight = start.weight;
        }
        return weight;
    }

private:
    SceneBuilder b_;
};

SceneMaterial fresnel(double index) {
    SceneMaterial m = SceneBuilder::dark();
    m.mirror = Mirror::fresnel;
    m.speed = 1 / index;
    return m;
}
SceneMaterial clear(double transmission) {
    SceneMaterial m = SceneBuilder::dark();
    m.transmission = Colour{transmission};
    m.speed = 1 / 1.5;
    return m;
}
SceneMaterial murky(const Colour& absorption) {
    SceneMaterial m = SceneBuilder::dark();
    m.transmission = Colour{1};
    m.absorption = absorption;
    return m;
}

void expect_both(const Stack& stack, double share) {
    EXPECT_NEAR(stack.in_light().x, share, 1e-12);
    EXPECT_NEAR(stack.in_view().x, share, 1e-12);
}

double passing(double from, double to) { return 1 - std::pow((from - to) / (from + to), 2); }

TEST(ShadowMedia, of_fresnel_mirrors_are_those_on_both_sides_of_each_wall) {
    const double air_glass = passing(1, 1.5), air_water = passing(1, 1.33), water_glass = passing(1.33, 1.5);
    expect_both(Stack().slab(-1, 1, fresnel(1.5)), air_glass * air_glass);
    expect_both(Stack().slab(-1, 1, fresnel(1.5)).slab(1, 3, fresnel(1.5)), air_glass * air_glass);
    expect_both(Stack().slab(-1, 1, fresnel(1.33)).slab(1, 3, fresnel(1.5)),
                air_water * water_glass * air_glass);
    expect_both(Stack().slab(-2, 2, fresnel(1.33)).slab(-1, 1, fresnel(1.5), 1),
                air_water * air_water * water_glass * water_glass);
    expect_both(Stack().slab(-2, 2, fresnel(1.33), 1).slab(-1, 1, fresnel(1.5)), air_water * air_water);
}

TEST(ShadowMedia, boundaries_that_coincide_are_crossed_at_once) {
    expect_both(Stack().slab(-1, 1, clear(0.9)).slab(1, 3, clear(0.9)), 0.9 * 0.9 * 0.9);
    expect_both(Stack().slab(-1, 1, clear(0.9)).slab(1, 3, clear(0.8)), 0.9 * 0.9 * 0.8);
    expect_both(Stack().slab(1, 3, clear(0.8)).slab(-1, 1, clear(0.9)), 0.9 * 0.8 * 0.8);
    expect_both(Stack().slab(-1, 1, clear(0.9)).slab(1.001, 3, clear(0.9)), 0.9 * 0.9 * 0.9 * 0.9);
}

TEST(ShadowMedia, absorb_by_the_rule_that_the_scene_has) {
    for (const bool notes : {false, true}) {
        Stack stack;
        stack.slab(-2, 2, murky({0.1, 0.2, 0.3})).slab(-1, 1, murky({0.7, 0, 0.05}), 1);
        if (notes) stack.by_the_notes();
        const Colour light = stack.in_light(), view = stack.in_view();
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(light[c], view[c], 1e-12) << notes;
        // By the notes' rule there is air behind the inner slab.
        EXPECT_NEAR(light.x, std::exp(-(notes ? 0.1 + 1.4 : 0.2 + 1.4)), 1e-12);
    }
}

// By the notes' rule a wall that two solids share leads into the one that is first in the file, or out of it.
TEST(ShadowMedia, that_touch_absorb_by_the_notes_as_the_first_in_the_file_says) {
    for (const bool lower_first : {false, true}) {
        Stack stack;
        const SceneMaterial glass = murky({0.4, 0.4, 0.4});
        if (lower_first)
            stack.slab(-1, 1, glass).slab(1, 3, glass);
        else
            stack.slab(1, 3, glass).slab(-1, 1, glass);
        stack.by_the_notes();
        EXPECT_NEAR(stack.in_light().x, stack.in_view().x, 1e-12) << lower_first;
        EXPECT_NEAR(stack.in_light().x, std::exp(-0.4 * (lower_first ? 2 : 4)), 1e-12) << lower_first;
    }
}

} // namespace
} // namespace rayscope::test
