#include "tests/oracle/cavity_checks.hpp"

#include "core/extents/scan.hpp"
#include "core/reflection/mirror.hpp"
#include "core/scene/build.hpp"
#include "core/tracer/interaction.hpp"
#include "tests/oracle/comparison.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"
#include "tests/support/scenes.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

using Fault = std::optional<std::string>;

using Long = long double;

World<double> mirror_cube() {
    SceneBuilder b;
    b.generic(Cube<double>{}, Mat4d{1}, b.clear(1, 0, 1), "cube");
    return build(b.scene());
}

// The tracer's own steps, one after the other: a recursion of this depth would need a large stack.
Fault cavity_fault(const World<double>& world, const CavityCase& exact) {
    const Scan<double> stage(world);
    Work<double> work;
    NullRecorder recorder;
    Leaving<double> leaving;
    Ray<double> ray = exact.ray;
    std::array<int, 3> walls{};
    Long path = 0; // the sum is not what is tested
    for (int n = 0; n < exact.bounces; ++n) {
        const auto nearest = stage.closest(ray, Range<double>{}, leaving, work, recorder);
        if (!nearest) return text("leaves the cube after ", n, " bounces");
        const Interaction<double> at = interact(world, ray, nearest, leaving, none, work);
        path += Long(at.hit.t) * Long(length(ray.direction)) / Long(length(exact.ray.direction));
        ++walls.at(std::size_t(at.hit.surface.face) / 2);
        ray = {at.point, mirrored<double>(at.incoming, at.facing)};
        leaving = at.back;
    }
    if (walls != exact.wall_counts) return "bounces on other walls";
    const double allowed = allowed_of(exact.tolerance); // grows with the number of bounces
    if (const double off = double(std::abs(path - Long(exact.length))); !(off <= allowed))
        return text("path off by ", hex(off), ", allowed are ", hex(allowed));
    if (const double off = largest_component(absolute(ray.origin - exact.end)); !(off <= allowed))
        return text("end off by ", hex(off), ", allowed are ", hex(allowed));
    if (const double off = length(ray.direction - normalized(exact.end_direction)); !(off <= allowed))
        return text("direction off by ", hex(off));
    return {};
}

} // namespace

void expect_cavity(const std::vector<CavityCase>& cases) {
    constexpr int printed = 5;
    const World<double> world = mirror_cube();
    int wrong = 0;
    for (const CavityCase& exact : cases) {
        const Fault fault = cavity_fault(world, exact);
        if (fault && wrong++ < printed)
            ADD_FAILURE() << *fault << "\n  in " << exact.id << "\n  ray " << hex(exact.ray.origin) << ", "
                          << hex(exact.ray.direction);
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

} // namespace rayscope::test
