// What does each stage buy? Time, tests and cells per ray, time to build and memory, stage by stage and scene by scene.

#include "bench/program/benchmarks.hpp"
#include "bench/stages/stage_report.hpp"
#include "bench/support/child.hpp"
#include "bench/support/ratios.hpp"
#include "core/files/atomic_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

namespace rayscope::bench {
namespace {

struct Options {
    std::filesystem::path folder;
    std::vector<std::string> scenes;
    std::size_t most = 100000;
    bool peers = false;
    Arguments rest{"rayscope-bench"};
};

constexpr std::array<const char*, 5> results{"stages.json", "stages.csv", "growth.json", "stages.md",
                                             "stages.png"};

int fail(const std::string& message) {
    std::fprintf(stderr, "rayscope-bench: %s\n", message.c_str());
    return 2;
}

int explain() {
    std::puts("Usage: rayscope bench stages [--scenes NAME…] [--most N] [--peers] -o DIR\n\n"
              "  --scenes NAME…  only scenes whose names begin so: cloud, flake, bowls, cylinders, gears\n"
              "  --most N        clouds of up to N balls (100000)\n"
              "  --peers         also run POV-Ray and Embree, where they are installed\n"
              "  -o DIR          stages.json (for Google Benchmark's compare tools), stages.csv, stages.md,\n"
              "                  growth.json and, with VTK, stages.png\n\n"
              "Example:\n  rayscope bench stages --scenes cloud flake -o stages");
    return 0;
}

// What is wrong, or nothing.
std::optional<std::string> read(const Arguments& words, Options& options) {
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::string& word = words[i];
        const auto next = [&] { return i + 1 < words.size() && !words[i + 1].starts_with("-"); };
        if (word == "--peers") {
            options.peers = true;
        } else if (word == "-o") {
            if (!next()) return "-o: expected a folder after it, found none";
            options.folder = words[++i];
        } else if (word == "--scenes") {
            if (!next()) return "--scenes: expected names after it, found none";
            while (next()) options.scenes.push_back(words[++i]);
        } else if (word == "--most") {
            char* end = nullptr;
            if (!next()) return "--most: expected a number after it, found none";
            const double number = std::strtod(words[++i].c_str(), &end);
            if (*end != '\0' || !(number >= 100 && number <= 1e7))
                return "--most: expected a number between 100 and 1e7, found '" + words[i] + "'";
            options.most = std::size_t(number);
        } else if (word.starts_with("--benchmark_")) {
            options.rest.push_back(word);
        } else {
            return "unexpected argument '" + word + "'; rayscope bench stages --help tells more";
        }
    }
    if (options.folder.empty()) return "expected -o and a folder for the results";
    return std::nullopt;
}

void put(const std::filesystem::path& path, const std::string& text) {
    write_text_file(path, text);
    std::printf("%s\n", path.string().c_str());
}

// The peers' own programs say what they measured.
std::string peers_said() {
    std::string text;
    const auto embree = program_folder() / "bench_embree";
    text += std::filesystem::exists(embree) ? output_of({embree.string()})
                                            : "Embree: not built (needs libembree-dev)\n";
    text += output_of({RAYSCOPE_POVRAY, "3"});
    return text;
}

void draw(const std::filesystem::path& folder) {
    const auto view = program_folder() / "rayscope-view";
    if (!std::filesystem::exists(view)) return;
    if (run_child({view.string(), "stages", (folder / "growth.json").string()}) == 0)
        std::printf("%s\n", (folder / "stages.png").string().c_str());
}

} // namespace

int stages_cost(const Arguments& words) {
    for (const std::string& word : words)
        if (word == "-h" || word == "--help") return explain();
    Options options;
    if (const auto wrong = read(words, options)) return fail(*wrong);
    const auto scenes = stage_scenes(options.scenes, options.most);
    if (scenes.empty())
        return fail("no scene's name begins so; expected cloud, flake, bowls, cylinders or gears");
    std::error_code error;
    std::filesystem::create_directories(options.folder, error);
    if (error) return fail("can't make the folder " + options.folder.string() + ": " + error.message());
    try {
        for (const char* name : results) check_writable(options.folder / name);
    } catch (const std::runtime_error& problem) {
        return fail(problem.what());
    }

    std::vector<StageRun> runs;
    for (const auto& scene : scenes) {
        const auto found = register_stages(scene);
        if (!found) return 1; // said already
        runs.insert(runs.end(), found->begin(), found->end());
    }
    Arguments arguments = options.rest;
    arguments.insert(arguments.begin() + 1, {"--benchmark_min_time=0.02", "--benchmark_out_format=json",
                                             "--benchmark_out=" + (options.folder / "stages.json").string()});
    const auto times = run_interleaved(arguments, 3);
    if (!times) return 2; // said already
    std::erase_if(runs, [&](const StageRun& run) { return !times->seconds.contains(run.benchmark); });
    if (runs.empty()) return fail("nothing was measured: --benchmark_filter leaves out everything");
    for (StageRun& run : runs) run.nanoseconds = 1e9 * times->quantile(run.benchmark, 0.5) / run.nanoseconds;

    const auto growth = growth_of(runs);
    std::printf("%s\n", (options.folder / "stages.json").string().c_str());
    put(options.folder / "stages.csv", csv_of(runs));
    put(options.folder / "growth.json", json_of(growth));
    put(options.folder / "stages.md", page_of(runs, growth, options.peers ? peers_said() : ""));
    const bool has_lines = std::ranges::any_of(growth, [](const Growth& g) { return g.points.size() > 1; });
    if (has_lines)
        draw(options.folder);
    else // none is better than one of another run
        std::filesystem::remove(options.folder / "stages.png", error);
    return 0;
}

} // namespace rayscope::bench
