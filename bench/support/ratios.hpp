#pragma once
// Speeds as ratios within one run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace rayscope::bench {

/// Runs all registered benchmarks, repeated and interleaved (A B C A B C …), and prints for each the median time and
/// its ratio to the first one registered, with the spread of that ratio between the quickest and the slowest
/// repetition. Seconds of two runs can't be compared; two ratios can.
inline int run_and_compare(int argc, char** argv, int repetitions = 9) {
    class Collector : public benchmark::ConsoleReporter {
    public:
        std::map<std::string, std::vector<double>> seconds;
        std::map<std::int64_t, std::string> order; // as registered, though they run in random order
        bool ReportContext(const Context&) override { return true; }
        void ReportRuns(const std::vector<Run>& runs) override {
            for (const Run& run : runs) {
                if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
                order[run.family_index] = run.run_name.function_name;
                seconds[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                              double(run.iterations));
            }
        }
    };
    std::string repeat = "--benchmark_repetitions=" + std::to_string(repetitions);
    std::string interleave = "--benchmark_enable_random_interleaving=true";
    std::vector<char*> arguments(argv, argv + argc);
    arguments.push_back(repeat.data());
    arguments.push_back(interleave.data());
    int count = int(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);

    const auto quantile = [&](const std::string& name, double q) {
        auto list = collector.seconds.at(name);
        std::sort(list.begin(), list.end());
        return list[std::size_t(q * double(list.size() - 1))];
    };
    std::printf("%-24s %14s %8s  %s\n", "benchmark", "median", "ratio", "ratio: least … most");
    for (const auto& [family, name] : collector.order) {
        const double base = quantile(collector.order.begin()->second, 0.5);
        std::printf("%-24s %11.1f ns %8.3f  %.3f … %.3f\n", name.c_str(), 1e9 * quantile(name, 0.5),
                    quantile(name, 0.5) / base, quantile(name, 0) / base, quantile(name, 1) / base);
    }
    return 0;
}

} // namespace rayscope::bench
