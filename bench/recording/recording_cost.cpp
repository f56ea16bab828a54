// What does recording cost where nothing is recorded? The tracer with NullRecorder against the same tracer with its
// recording statements taken out of the source.

#include "bench/recording/traced_world.hpp"
#include "bench/support/ratios.hpp"

namespace rayscope_stripped {
[[nodiscard]] double trace_world(); // the same file, compiled under this namespace
}

static void Stripped(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(rayscope_stripped::trace_world());
}
static void NullRecorder(benchmark::State& state) {
    for (auto _ : state) benchmark::DoNotOptimize(rayscope::trace_world());
}
BENCHMARK(Stripped);
BENCHMARK(NullRecorder);

int main(int argc, char** argv) {
    const double plain = rayscope_stripped::trace_world(), silent = rayscope::trace_world();
    if (plain != silent) {
        std::fprintf(stderr, "the two tracers disagree: %a and %a\n", plain, silent);
        return 1;
    }
    return rayscope::bench::run_and_compare(argc, argv);
}
