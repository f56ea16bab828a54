// Does a compound of 10⁵ nodes cost 10 times what one of 10⁴ costs? A ray through unions and differences of n thin
// plates, per plate, in units of the smallest.

#include "bench/support/ratios.hpp"
#include "core/rayscope.hpp"

namespace {

using namespace rayscope;

// Plates along x, one behind the other: a ray along x is inside each of them.
Workbench plates(int n, Operation operation) {
    Scene scene;
    scene.file = "bench";
    scene.materials.emplace_back();
    SceneCompound compound;
    compound.material = 0;
    for (int i = 0; i < n; ++i) {
        SceneGeneric plate;
        plate.shape = Cube<double>{};
        plate.matrix[0][0] = 0.25;
        plate.matrix[3][0] = i;
        if (i == 0 && operation == Operation::difference) { // the block that the others are cut from
            plate.matrix[0][0] = n;
            plate.matrix[3][0] = n;
        }
        compound.nodes.push_back({Operation::leaf, 0, 0, false, scene.generics.size(), {}});
        if (i > 0) {
            const std::size_t last = compound.nodes.size();
            compound.nodes.push_back({operation, i == 1 ? 0 : last - 2, last - 1, false, 0, {}});
        }
        scene.generics.push_back(plate);
    }
    scene.drawn.push_back({true, 0});
    scene.compounds.push_back(std::move(compound));
    return make_workbench(std::move(scene));
}

void measure(const std::string& name, int n, Operation operation) {
    auto bench = std::make_shared<Workbench>(plates(n, operation));
    benchmark::RegisterBenchmark(name.c_str(), [bench, n](benchmark::State& state) {
        const Ray<double> ray{{-5, 0, 0}, {1, 0, 0}};
        while (state.KeepRunningBatch(n)) benchmark::DoNotOptimize(spans(*bench, ray));
    });
}

} // namespace

int main(int argc, char** argv) {
    for (const int n : {1000, 10000, 100000}) {
        measure("union of " + std::to_string(n), n, Operation::set_union);
        measure("difference of " + std::to_string(n), n, Operation::difference);
    }
    return bench::run_and_compare(argc, argv, 5);
}
