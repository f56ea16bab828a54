// instructions KERNEL: runs one kernel a fixed number of times between two marks, for callgrind to count, and prints a
// checksum of what came out. Without an argument: the names of the kernels.

#include "core/csg/sweep.hpp"
#include "core/extents/scan.hpp"
#include "core/generics/cone.hpp"
#include "core/generics/sphere.hpp"
#include "core/generics/torus.hpp"
#include "core/rayscope.hpp"
#include "core/refraction/snell.hpp"
#include "core/tracer/tracer.hpp"

#include <array>
#include <bit>
#include <cstdio>
#include <random>
#include <string_view>
#include <vector>

namespace {

using namespace rayscope;

constexpr int repetitions = 200;

/// FNV-1a over the bits of what a kernel computes: equal work, equal sum.
class Checksum {
public:
    void add(double value) { hash_ = (hash_ ^ std::bit_cast<std::uint64_t>(value)) * 0x100000001b3U; }
    void add(const Vec3d& v) {
        for (int i = 0; i < 3; ++i) add(v[i]);
    }
    [[nodiscard]] std::uint64_t value() const { return hash_; }

private:
    std::uint64_t hash_ = 0xcbf29ce484222325U;
};

/// Numbers in [-1, 1) from the engine's bits alone: std's distributions differ between libraries.
class Random {
public:
    [[nodiscard]] double next() { return double(std::int32_t(engine_())) * 0x1p-31; }
    [[nodiscard]] Vec3d point() {
        const double x = next(), y = next(), z = next();
        return {x, y, z};
    }

private:
    std::mt19937 engine_{1};
};

/// Rays from a shell of radius 3 … 6 through the cube [-1, 1]³: about half of them hit.
std::vector<Ray<double>> rays() {
    Random random;
    std::vector<Ray<double>> list;
    for (int i = 0; i < 256; ++i) {
        const Vec3d from = (4.5 + 1.5 * random.next()) * normalized(random.point());
        list.push_back({from, normalized(random.point() - from)});
    }
    return list;
}

struct Kernel {
    const char* name;
    void (*run)(Checksum&);
};

/// The one function in which callgrind counts.
extern "C" [[gnu::noinline]] void measured(void (*run)(Checksum&), Checksum& checksum) { run(checksum); }

template <typename Shape> void intersect(Checksum& checksum) {
    // Scaled, sheared and moved: the way through a matrix is part of the cost.
    const Mat4d matrix{{1.2, 0, 0, 0}, {0.3, 0.8, 0, 0}, {0, 0.1, 1, 0}, {0.1, -0.2, 0.3, 1}};
    static const Solid<double> solid{Shape{}, Transform<double>{matrix}};
    static const auto list = rays();
    for (int n = 0; n < repetitions; ++n)
        for (const auto& ray : list)
            for (const auto& inside : solid.intervals(ray)) {
                checksum.add(inside.enter);
                checksum.add(inside.exit);
            }
}

/// A chain of unions, differences and intersections of lists with eight spans each.
void sweep(Checksum& checksum) {
    constexpr std::uint32_t lists = 12, spans = 8;
    SpanStack<double> stack;
    const auto push = [&](std::uint32_t list) {
        stack.push();
        for (std::uint32_t i = 0; i < 2 * spans; ++i)
            stack.append({0.37 * list + i * (1 + 0.01 * list), {list, 0, false}, i % 2 == 0});
    };
    constexpr std::array operations{Operation::set_union, Operation::difference, Operation::intersection,
                                    Operation::set_union};
    for (int n = 0; n < repetitions; ++n) {
        stack.clear();
        push(0);
        for (std::uint32_t list = 1; list < lists; ++list) {
            push(list);
            stack.combine(operations[list % operations.size()]);
        }
        for (std::size_t i = 0; i < stack.top_size(); ++i) checksum.add(stack.top_begin()[i].t);
    }
}

void refraction(Checksum& checksum) {
    static const auto list = rays();
    for (int n = 0; n < repetitions; ++n)
        for (std::size_t i = 0; i + 1 < list.size(); ++i)
            checksum.add(refract<double>(list[i].direction, list[i + 1].origin, 1.0, n % 2 == 0 ? 0.66 : 1.33)
                             .direction);
}

/// A glass ball and a mirror over a floor, with a light: the whole recursion, tests included.
Workbench balls_on_floor() {
    Scene scene;
    SceneMaterial matt, glass, mirror;
    glass.transmission = Colour{0.9};
    glass.speed = 0.66;
    mirror.reflection = Colour{0.8};
    scene.materials = {matt, glass, mirror};
    SceneLight light;
    light.position = {3, -4, 6};
    scene.lights = {light};
    const auto add = [&](const Generic<double>& shape, const Vec3d& at, std::size_t material) {
        SceneGeneric generic;
        generic.shape = shape;
        generic.matrix[3] = {at.x, at.y, at.z, 1};
        generic.material = material;
        scene.drawn.push_back({false, scene.generics.size()});
        scene.generics.push_back(generic);
    };
    add(Plane<double>{}, {0, 0, -1}, 0);
    add(Sphere<double>{}, {-0.7, 0, 0}, 1);
    add(Cylinder<double>{}, {0.9, 0.8, 0}, 2);
    return make_workbench(std::move(scene));
}

template <EffectMask mask> void shade(Checksum& checksum) {
    static const Workbench bench = balls_on_floor();
    static const Scan<double> stage(bench.world);
    static const auto list = rays();
    Work<double> work;
    NullRecorder recorder;
    Tracer<double, Scan<double>, NullRecorder, DepthFirst, mask> tracer(bench.world, stage, work, recorder);
    for (int n = 0; n < repetitions / 20; ++n)
        for (const auto& ray : list) checksum.add(tracer.trace(ray));
}

constexpr std::array kernels{
    Kernel{"sphere", intersect<Sphere<double>>},
    Kernel{"cone", intersect<Cone<double>>},
    Kernel{"torus", intersect<Torus<double>>},
    Kernel{"sweep", sweep},
    Kernel{"refraction", refraction},
    Kernel{"shade", shade<EffectMask::classic>},
    Kernel{"shade_all", shade<EffectMask::all>},
};

} // namespace

int main(int argc, char** argv) {
    for (const Kernel& kernel : kernels) {
        if (argc < 2) {
            std::puts(kernel.name);
        } else if (std::string_view(argv[1]) == kernel.name) {
            Checksum checksum;
            measured(kernel.run, checksum);
            std::printf("%016llx\n", static_cast<unsigned long long>(checksum.value()));
            return 0;
        }
    }
    return argc < 2 ? 0 : 2;
}
