// How long does the recorded trace of one pixel take among many solids? Through a cloud of balls, each hit of which sends a
// ray to the light and a mirrored one: by stages that look where the ray goes, and by a test of every ball, in units of the
// quickest. The traces are compared before. An engineer who clicks a pixel waits for this.

#include "bench/support/clouds.hpp"
#include "bench/support/ratios.hpp"
#include "core/rayscope.hpp"

#include <array>
#include <cstdio>

namespace {

using namespace rayscope;

constexpr std::size_t count = 100'000;
constexpr int edge = 512; // of the image; the pixels lie on a grid in it, so that many kinds of ray take part
constexpr std::array<const char*, 2> stages{"octree", "bvh"};

struct Pixel {
    int x, y;
};
Pixel pixel(std::size_t i) {
    constexpr std::size_t across = 8;
    return {int(i % across) * 56 + 60, int(i / across % across) * 56 + 60};
}

} // namespace

int main(int argc, char** argv) {
    const auto bench =
        std::make_shared<Workbench>(make_workbench(bench::cloud(count, bench::covering_radius(count, 2))));
    const auto trace = [bench](const StageSet& set, std::size_t i) {
        return trace_pixel(*bench, set, pixel(i).x, pixel(i).y, edge, edge);
    };
    std::vector<std::shared_ptr<const StageSet>> sets;
    for (const char* stage : stages) sets.push_back(make_stages(*bench, stage_choice(stage), edge, edge));
    for (std::size_t i = 0; i < 64; ++i)
        for (const auto& set : sets)
            if (trace(*set, i).colour != trace(*sets.front(), i).colour) {
                std::fprintf(stderr, "pixel %d,%d: other light\n", pixel(i).x, pixel(i).y);
                return 1;
            }
    for (std::size_t s = 0; s < sets.size(); ++s)
        benchmark::RegisterBenchmark(stages[s], [=](benchmark::State& state) {
            std::size_t i = 0;
            while (state.KeepRunning()) benchmark::DoNotOptimize(trace(*sets[s], i++));
        });
    benchmark::RegisterBenchmark("every ball", [=](benchmark::State& state) {
        std::size_t i = 0;
        while (state.KeepRunning())
            benchmark::DoNotOptimize(trace_pixel(*bench, pixel(i).x, pixel(i).y, edge, edge)), ++i;
    });
    return bench::run_and_compare(argc, argv, 5);
}
