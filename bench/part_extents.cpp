// What do boxes around the parts of a compound buy? Whole images, with every ray against every object: first without
// those boxes, then with them, in units of the first. Checksums are compared before.

#include "bench/support/ratios.hpp"
#include "bench/support/worlds.hpp"
#include "core/rayscope.hpp"

#include <cmath>

namespace {

using namespace rayscope;

/// One union of n small solids, spheres alone or every other one a torus, scattered in a cube of edge 8.
Scene scattered(int n, bool tori) {
    Scene scene = bench::stand(8);
    SceneCompound compound;
    compound.material = 0;
    for (int i = 0; i < n; ++i) {
        const auto coordinate = [i](double step) { return 8 * std::fmod(i * step, 1.0) - 4; };
        SceneGeneric part;
        if (tori && i % 2 == 1) part.shape = Torus<double>{};
        part.matrix = Mat4d{0.25};
        part.matrix[3] = {coordinate(0.618034), coordinate(0.754878), coordinate(0.569840), 1};
        compound.nodes.push_back({Operation::leaf, 0, 0, false, scene.generics.size(), {}});
        if (i > 0) {
            const std::size_t last = compound.nodes.size();
            compound.nodes.push_back({Operation::set_union, i == 1 ? 0 : last - 2, last - 1, false, 0, {}});
        }
        scene.generics.push_back(part);
    }
    scene.drawn.push_back({true, scene.compounds.size()});
    scene.compounds.push_back(std::move(compound));
    return scene;
}

bool measure(const std::string& name, Scene scene) {
    auto kept = std::make_shared<Workbench>(make_workbench(std::move(scene)));
    const auto render_by = [kept](const char* stage) {
        RenderOptions options;
        options.width = options.height = 64;
        options.threads = 1;
        options.stage = stage_choice(stage);
        return render(*kept, options).image;
    };
    if (!(hash(render_by("scan")) == hash(render_by("extents")))) {
        std::fprintf(stderr, "%s: other images\n", name.c_str());
        return false;
    }
    for (const char* stage : {"scan", "extents"})
        benchmark::RegisterBenchmark((name + ", " + stage).c_str(), [=](benchmark::State& state) {
            while (state.KeepRunning()) benchmark::DoNotOptimize(render_by(stage));
        });
    return true;
}

} // namespace

int main(int argc, char** argv) {
    const bool same = measure("union of 20 spheres", scattered(20, false)) &&
                      measure("union of 200 spheres", scattered(200, false)) &&
                      measure("union of 20 spheres and tori", scattered(20, true)) &&
                      measure("union of 200 spheres and tori", scattered(200, true)) &&
                      measure("one gear", bench::gears(1)) && measure("one bowl", bench::bowls(1));
    return same ? bench::run_and_compare(argc, argv, 5) : 1;
}
