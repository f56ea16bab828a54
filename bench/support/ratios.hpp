#pragma once
// Speeds as ratios within one run.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::bench {

/// What each benchmark took: seconds for one iteration, one number for each repetition.
struct Times {
    std::vector<std::string> names; ///< as registered, though they run in random order
    std::map<std::string, std::vector<double>> seconds;

    /// The q-th part of the repetitions was at most this quick; 0.5 is the median.
    [[nodiscard]] double quantile(const std::string& name, double q) const {
        auto list = seconds.at(name);
        std::sort(list.begin(), list.end());
        return list[std::size_t(q * double(list.size() - 1))];
    }
};

/// Runs all registered benchmarks, repeated and interleaved (A B C A B C …). Nothing if an argument is unknown, which
/// is said.
inline std::optional<Times> run_interleaved(std::vector<std::string> arguments, int repetitions) {
    class Collector : public benchmark::ConsoleReporter {
    public:
        Times times;
        std::map<std::int64_t, std::string> order;
        bool ReportContext(const Context&) override { return true; }
        void ReportRuns(const std::vector<Run>& runs) override {
            for (const Run& run : runs) {
                if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
                order[run.family_index] = run.run_name.function_name;
                times.seconds[run.run_name.function_name].push_back(run.cpu_accumulated_time /
                                                                    double(run.iterations));
            }
        }
    };
    arguments.push_back("--benchmark_repetitions=" + std::to_string(repetitions));
    arguments.emplace_back("--benchmark_enable_random_interleaving=true");
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    int count = int(pointers.size());
    benchmark::Initialize(&count, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(count, pointers.data())) return std::nullopt;
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    for (const auto& [family, name] : collector.order) collector.times.names.push_back(name);
    return std::move(collector.times);
}

/// Runs them, and prints for each the median time and its ratio to the first one registered, with the spread of that
/// ratio between the quickest and the slowest repetition. Seconds of two runs can't be compared; two ratios can.
inline int run_and_compare(int argc, char** argv, int repetitions = 9) {
    const auto times = run_interleaved({argv, argv + argc}, repetitions);
    if (!times) return 2;
    std::printf("%-24s %14s %8s  %s\n", "benchmark", "median", "ratio", "ratio: least … most");
    for (const std::string& name : times->names) {
        const double base = times->quantile(times->names.front(), 0.5);
        std::printf("%-24s %11.1f ns %8.3f  %.3f … %.3f\n", name.c_str(), 1e9 * times->quantile(name, 0.5),
                    times->quantile(name, 0.5) / base, times->quantile(name, 0) / base,
                    times->quantile(name, 1) / base);
    }
    return 0;
}

} // namespace rayscope::bench
