#include "bench/recording/traced_world.hpp"

#include "core/extents/scan.hpp"
#include "core/tracer/tracer.hpp"
#include "core/world/camera.hpp"

namespace rayscope {
namespace {

std::uint32_t add_sphere(World<double>& world, const Vec3d& centre, double radius) {
    Mat4d translation{1};
    translation[3] = {centre, 1};
    Solid<double> solid;
    solid.shape = Sphere<double>{radius};
    solid.transform = Transform<double>(translation);
    solid.is_ball = true;
    solid.object = std::uint32_t(world.objects.size());
    world.solids.push_back(solid);
    return std::uint32_t(world.solids.size() - 1);
}

World<double> make_world() {
    World<double> world;
    world.background = {0.2, 0.3, 0.5};
    world.max_depth = 4;
    Material mirror;
    mirror.ambient = Colour{0.1};
    mirror.diffuse = Colour{0.5};
    mirror.specular = Colour{0.3};
    mirror.shininess = 20;
    mirror.reflection = Colour{0.4};
    Material glass = mirror;
    glass.transmission = Colour{0.5};
    glass.speed = 1 / 1.5;
    world.materials = {mirror, glass};
    world.lights = {{false, {4, 6, 5}, Colour{1}, true}};
    for (int i = 0; i < 48; ++i) {
        const double angle = 0.7 * i;
        const auto solid = add_sphere(world, {2 * std::cos(angle), 0.08 * i - 2, 2 * std::sin(angle)}, 0.4);
        world.objects.push_back({false, solid, 0, 0, true, Box<double>::everything()});
    }
    Compound bowl;
    bowl.nodes.push_back({Operation::leaf, 0, 0, add_sphere(world, {0, 0, 0}, 1.2)});
    bowl.nodes.push_back({Operation::leaf, 0, 0, add_sphere(world, {0, 0.3, 0}, 1.1)});
    bowl.nodes.push_back({Operation::difference, 0, 1, 0});
    bowl.program = compile(bowl.nodes);
    world.compounds.push_back(bowl);
    world.objects.push_back({true, 0, 1, 0, true, Box<double>::everything()});
    world.media = MediaNeighbours({std::uint32_t(world.objects.size() - 1)}, {{Box<double>::everything()}});
    return world;
}

} // namespace

double trace_world() {
    static const World<double> world = make_world();
    static const Scan<double> stage(world);
    static Work<double> work;
    constexpr int size = 64;
    const EyeRays eye_rays({{0, 1, 7}, {0, 0, 0}, {0, 1, 0}, 45, size, size}, size, size);
    NullRecorder recorder;
    Tracer<double, Scan<double>, NullRecorder, DepthFirst, EffectMask::classic> tracer(world, stage, work,
                                                                                       recorder);
    Colour sum{0};
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) sum += tracer.trace(eye_rays.through(x + 0.5, y + 0.5));
    return sum.x + sum.y + sum.z;
}

} // namespace rayscope
