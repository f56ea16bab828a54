// rayscope bench effects: what each effect costs on one scene, and what samples at edges alone save.

#include "bench/program/benchmarks.hpp"
#include "bench/support/ratios.hpp"
#include "core/rayscope.hpp"

#include <cmath>

namespace rayscope::bench {
namespace {

constexpr int side = 128, samples = 16;

SceneMaterial matt(const Colour& diffuse) {
    SceneMaterial material;
    material.diffuse = diffuse;
    return material;
}

/// A glass ball, a mirror and a post on a floor, with one light: the notes' effects and no other.
Scene plain_scene() {
    Scene scene;
    scene.file = "bench";
    scene.camera.eye = {0, -7, 2.5};
    scene.camera.up = {0, 0, 1};
    scene.camera.width = scene.camera.height = side;
    scene.background = {0.3, 0.4, 0.6};
    SceneMaterial glass, mirror;
    glass.diffuse = mirror.diffuse = Colour{0.05};
    glass.transmission = Colour{0.9};
    glass.speed = 1 / 1.5;
    mirror.reflection = Colour{0.8};
    scene.materials = {matt({0.7, 0.6, 0.5}), glass, mirror, matt({0.3, 0.6, 0.3})};
    SceneLight light;
    light.position = {4, -4, 6};
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
    add(Sphere<double>{}, {-1.2, -0.6, 0}, 1);
    add(Sphere<double>{}, {1.3, 0.4, 0}, 2);
    add(Cylinder<double>{}, {0, 2.5, 0}, 3);
    return scene;
}

RenderOptions one_thread() {
    RenderOptions options;
    options.threads = 1;
    return options;
}

void add_benchmark(const std::string& name, const Scene& scene, const RenderOptions& options = one_thread()) {
    const auto bench = std::make_shared<Workbench>(make_workbench(scene));
    benchmark::RegisterBenchmark(name.c_str(), [bench, options](benchmark::State& state) {
        for (auto _ : state) benchmark::DoNotOptimize(render(*bench, options).image.rgb.data());
    });
}

/// Of the bytes that a screen shows.
double psnr(const Image& image, const Image& exact) {
    double squares = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const auto a = srgb_bytes(image.at(x, y)), b = srgb_bytes(exact.at(x, y));
            for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double(a[i]) - double(b[i]), 2);
        }
    return 10 * std::log10(255.0 * 255.0 * 3 * image.width * image.height / squares);
}

void print_antialiasing(const Scene& scene, const Times& times) {
    Scene smooth = scene;
    smooth.camera.samples = samples;
    const Workbench bench = make_workbench(smooth);
    RenderOptions everywhere;
    everywhere.even_samples = true;
    RenderOptions exact = everywhere;
    exact.samples = 256;
    const Image reference = render(bench, exact).image;
    const auto at_edges = render(bench, RenderOptions{});
    const double taken = [&] {
        double sum = 0;
        for (const float count : at_edges.samples.values) sum += double(count);
        return sum / double(at_edges.samples.values.size());
    }();
    std::printf(
        "\nPSNR to 256 samples everywhere: %d everywhere %.2f dB, at edges %.2f dB with %.2f a pixel,\n"
        "in %.3f of the time; one a pixel %.2f dB\n",
        samples, psnr(render(bench, everywhere).image, reference), psnr(at_edges.image, reference), taken,
        times.quantile("antialiasing", 0.5) / times.quantile("antialiasing everywhere", 0.5),
        psnr(render(make_workbench(scene), RenderOptions{}).image, reference));
}

} // namespace

int effects_cost(const Arguments& arguments) {
    const Scene scene = plain_scene();
    const Workbench plain = make_workbench(scene);
    const EffectSet needed = needed_effects(effect_needs(scene, plain.world));
    RenderOptions all = one_thread();
    all.all_effects = true;
    if (hash(render(plain, all).image) != hash(render(plain, one_thread()).image)) {
        std::fputs("the tracer with all effects makes another image of a scene that calls for none\n",
                   stderr);
        return 1;
    }
    add_benchmark("classic", scene);
    add_benchmark("all, none called for", scene, all);
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        Scene with = scene;
        if (!needed.has(Effect(i)) && add_effect(Effect(i), with))
            add_benchmark(std::string(effect_names[i].name), with);
    }
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        if (!needed.has(Effect(i))) continue;
        Scene without = scene;
        take_away(Effect(i), without);
        add_benchmark("without " + std::string(effect_names[i].name), without);
    }
    Scene smooth = scene;
    smooth.camera.samples = samples;
    RenderOptions everywhere = one_thread();
    everywhere.even_samples = true;
    add_benchmark("antialiasing everywhere", smooth, everywhere);

    constexpr int repetitions = 9;
    const auto times = run_interleaved(arguments, repetitions);
    if (!times) return 2;
    std::printf("%-26s %8s  %s\n", "effect", "time", "least … most, of the classic tracer's");
    const std::string& base = times->names.front();
    for (const std::string& name : times->names)
        std::printf("%-26s %8.3f  %.3f … %.3f\n", name.c_str(),
                    times->quantile(name, 0.5) / times->quantile(base, 0.5),
                    times->quantile(name, 0) / times->quantile(base, 0.5),
                    times->quantile(name, 1) / times->quantile(base, 0.5));
    print_antialiasing(scene, *times);
    return 0;
}

} // namespace rayscope::bench
