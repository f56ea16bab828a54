// rayscope-bench: the benchmarks that answer a question about the product, one table each.

#include "bench/program/benchmarks.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace {

using rayscope::bench::Arguments;

constexpr int wrong_usage = 2;

struct Benchmark {
    std::string_view name, summary;
    int (*run)(const Arguments&);
    bool reads_words = false; ///< it has options of its own
};

constexpr std::array benchmarks{
    Benchmark{"accuracy", "what accuracy costs: time and digits of each generic, number type and method",
              rayscope::bench::accuracy_cost},
    Benchmark{"effects", "what each effect costs on one scene, and what samples at edges alone save",
              rayscope::bench::effects_cost},
    Benchmark{"stages",
              "what each stage buys: time, tests and cells a ray, scene by scene; --help tells more",
              rayscope::bench::stages_cost, true},
};

int fail(const std::string& message) {
    std::fprintf(stderr, "rayscope-bench: %s\n", message.c_str());
    return wrong_usage;
}

int list() {
    std::puts("Usage: rayscope bench BENCHMARK [-o FILE] [options of Google Benchmark]\n");
    for (const Benchmark& benchmark : benchmarks)
        std::printf("  %-10s %s\n", std::string(benchmark.name).c_str(),
                    std::string(benchmark.summary).c_str());
    std::puts(
        "\n  -o FILE    also write every repetition to a file: .json (Google Benchmark's format) or .csv\n\n"
        "Example:\n  rayscope bench accuracy -o cost.json\n"
        "  rayscope bench accuracy --benchmark_filter='sphere|torus'\n"
        "  rayscope bench stages -o stages");
    return 0;
}

/// What is wrong with the file; nothing if it can be written.
std::string wrong_output(const std::filesystem::path& path) {
    if (path.extension() != ".json" && path.extension() != ".csv")
        return "-o: expected a file that ends in .json or .csv, found '" + path.string() + "'";
    std::error_code ignored;
    const bool was_there = std::filesystem::exists(path, ignored);
    std::FILE* const file = std::fopen(path.c_str(), "ab"); // minutes are lost if that shows only at the end
    if (file == nullptr) return "-o: can't write " + path.string() + ": " + std::strerror(errno);
    std::fclose(file);
    if (!was_there) std::filesystem::remove(path, ignored);
    return "";
}

int run(const Benchmark& benchmark, const Arguments& words) {
    if (benchmark.reads_words) return benchmark.run(words);
    Arguments arguments{"rayscope-bench"};
    std::optional<std::string> output;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "-h" || words[i] == "--help") return list();
        if (words[i] == "-o") {
            if (output) return fail("-o is given twice, expected it once");
            if (i + 1 == words.size()) return fail("-o: expected a file after it, found none");
            output = words[++i];
        } else if (words[i].starts_with("--benchmark_")) {
            arguments.push_back(words[i]);
        } else {
            return fail("unexpected argument '" + words[i] + "'; rayscope bench tells more");
        }
    }
    if (output) {
        if (const std::string wrong = wrong_output(*output); !wrong.empty()) return fail(wrong);
        arguments.push_back("--benchmark_out=" + *output);
        arguments.push_back("--benchmark_out_format=" + output->substr(output->rfind('.') + 1));
    }
    return benchmark.run(arguments);
}

int guarded(const Arguments& words) {
    if (words.empty() || words[0] == "-h" || words[0] == "--help") return list();
    std::string known;
    for (const Benchmark& benchmark : benchmarks) {
        if (benchmark.name == words[0]) return run(benchmark, {words.begin() + 1, words.end()});
        known += (known.empty() ? "" : ", ") + std::string(benchmark.name);
    }
    return fail("unknown benchmark '" + words[0] + "'; expected one of: " + known);
}

} // namespace

int main(int count, char** arguments) {
    try {
        return guarded({arguments + (count > 0 ? 1 : 0), arguments + count});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "rayscope-bench: %s\n", error.what());
        return 1;
    }
}
