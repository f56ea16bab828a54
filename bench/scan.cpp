// What does a ray cost that is tested against everything? One ray past 820 balls, past 820 of each other generic, and
// past 100 bowls, in units of the balls: per object tested.

#include "core/extents/scan.hpp"
#include "bench/support/ratios.hpp"
#include "core/rayscope.hpp"

namespace {

using namespace rayscope;

constexpr int count = 820;

Scene empty_scene() {
    Scene scene;
    scene.file = "bench";
    scene.materials.emplace_back();
    return scene;
}

// On a spiral around the ray: all near it, almost none met.
Mat4d placed(int i, const Vec3d& size) {
    const double angle = 0.37 * i, radius = 2.5 + 0.01 * i;
    Mat4d matrix{1};
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = size[axis];
    matrix[3] = {radius * std::cos(angle), radius * std::sin(angle), 0.05 * i, 1};
    return matrix;
}

Workbench many(const Generic<double>& shape, const Vec3d& size) {
    Scene scene = empty_scene();
    for (int i = 0; i < count; ++i) {
        SceneGeneric generic;
        generic.shape = shape;
        generic.matrix = placed(i, size);
        generic.material = 0;
        scene.drawn.push_back({false, scene.generics.size()});
        scene.generics.push_back(generic);
    }
    return make_workbench(std::move(scene));
}

Workbench bowls() {
    Scene scene = empty_scene();
    for (const double radius : {1.0, 0.85, 0.6}) {
        SceneGeneric generic;
        generic.shape = radius == 0.6 ? Generic<double>(Cone<double>{}) : Generic<double>(Sphere<double>{});
        generic.matrix[0][0] = generic.matrix[1][1] = generic.matrix[2][2] = radius;
        scene.generics.push_back(generic);
    }
    for (int i = 0; i < 100; ++i) {
        SceneCompound bowl;
        bowl.nodes = {{Operation::leaf, 0, 0, false, 0, {}},
                      {Operation::leaf, 0, 0, false, 1, {}},
                      {Operation::difference, 0, 1, false, 0, {}},
                      {Operation::leaf, 0, 0, false, 2, {}},
                      {Operation::difference, 2, 3, false, 0, {}}};
        bowl.matrix = placed(i, Vec3d{1});
        bowl.material = 0;
        scene.drawn.push_back({true, scene.compounds.size()});
        scene.compounds.push_back(bowl);
    }
    return make_workbench(std::move(scene));
}

void measure(const char* name, Workbench bench) {
    // The world stays where it is: the stage refers to it.
    auto kept = std::make_shared<Workbench>(std::move(bench));
    auto stage = std::make_shared<Scan<double>>(kept->world);
    benchmark::RegisterBenchmark(name, [kept, stage](benchmark::State& state) {
        Work<double> work;
        NullRecorder recorder;
        const Leaving<double> nothing;
        const auto objects = std::int64_t(kept->world.objects.size());
        Ray<double> ray{{0.01, 0.02, -5}, {0, 0, 1}};
        while (state.KeepRunningBatch(objects)) {
            ray.origin.x = -ray.origin.x;
            benchmark::DoNotOptimize(stage->closest(ray, {}, nothing, work, recorder));
        }
    });
}

} // namespace

int main(int argc, char** argv) {
    const Vec3d round{0.5}, stretched{0.5, 0.4, 0.3};
    measure("ball", many(Sphere<double>{}, round));
    measure("sphere, stretched", many(Sphere<double>{}, stretched));
    measure("plane", many(Plane<double>{}, stretched));
    measure("cube", many(Cube<double>{}, stretched));
    measure("cylinder", many(Cylinder<double>{}, stretched));
    measure("cone", many(Cone<double>{}, stretched));
    measure("torus", many(Torus<double>{0.3}, stretched));
    measure("bowl, 3 generics", bowls());
    return bench::run_and_compare(argc, argv, 5);
}
