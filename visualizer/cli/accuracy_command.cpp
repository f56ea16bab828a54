// rayscope accuracy: what each configuration of a scene costs, and how wrong it is.

#include "visualizer/cli/accuracy_files.hpp"
#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/interrupts.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/page.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/progress.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/warnings.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rayscope::cli {
namespace {

// Of the image's longer side, in pixels, where nobody says: a reference takes a minute or so, not a day.
constexpr int usual_side = 96;

Size reduced(const Camera& camera) {
    const int longer = std::max(camera.width, camera.height);
    if (longer <= usual_side) return {camera.width, camera.height};
    return {std::max(1, camera.width * usual_side / longer),
            std::max(1, camera.height * usual_side / longer)};
}

struct Stopped {};

class AccuracyCommand {
public:
    explicit AccuracyCommand(const AccuracyCommandOptions& options)
        : options_(options), path_(find_scene(options.scene)), scene_(load_scene(path_)) {
        try {
            configurations_ = configurations(options.configurations, own_configuration(scene_));
        } catch (const std::invalid_argument& error) {
            throw UsageError(std::string("--configs: ") + error.what());
        }
        if (options.output) prepare_folder(*options.output, "accuracy.json");
        print_warnings(scene_);
    }

    int run() {
        const Size size = options_.size.value_or(reduced(scene_.camera));
        catch_interrupts();
        AccuracyReport report;
        report.scene = path_.string();
        report.reference = reference(size);
        report.list = measured(configurations_, report.reference, options_.output.has_value());
        report.sentences = verdict(report.list, report.reference);
        std::fputs(accuracy_table(report).c_str(), stdout);
        if (options_.output) {
            const auto file = write_report(*options_.output, report);
            if (can_draw())
                draw_accuracy(file);
            else
                std::fprintf(stderr, "rayscope: no chart: %s\n", how_to_draw());
            std::fputs((harmless(file.string()) + "\n").c_str(), stdout);
        }
        return options_.target_error ? prove(report) : done;
    }

private:
    [[nodiscard]] Reference reference(Size size) const {
        ReferenceOptions options;
        options.width = size.width;
        options.height = size.height;
        options.limits.max_rays = options_.reference_rays;
        options.threads = options_.threads;
        options.cache = cache_folder();
        options.identity = content_hash(path_, scene_);
        options.stop = &stop_asked_for;
        Reference result;
        {
            Progress progress("reference");
            options.progress = [&](double share) { progress.show(share); };
            result = make_reference(scene_, options);
        }
        if (!result.note.empty()) std::fprintf(stderr, "rayscope: %s\n", harmless(result.note).c_str());
        if (!result.complete()) throw Stopped{};
        return result;
    }

    [[nodiscard]] std::vector<Measured> measured(const std::vector<Configuration>& list,
                                                 const Reference& against, bool maps) const {
        MeasureOptions options;
        options.runs = options_.runs;
        options.threads = options_.threads;
        options.stop = &stop_asked_for;
        if (maps)
            options.on_map = [&](const Configuration& configuration, const Map& map) {
                return write_error_map(*options_.output, configuration, map);
            };
        Progress progress("configurations");
        options.progress = [&](double share) { progress.show(share); };
        auto result = measure(scene_, list, against, options);
        if (result.empty()) throw Stopped{};
        return result;
    }

    // At the scene's own size; if the cheapest fails there, the next cheapest is tried.
    int prove(const AccuracyReport& report) const {
        const double target = *options_.target_error;
        std::vector<Measured> left = report.list;
        const Reference full = reference({scene_.camera.width, scene_.camera.height});
        while (const Measured* candidate = cheapest_within(left, report.reference, target)) {
            const Configuration chosen = candidate->configuration;
            const Measured proof = measured({chosen}, full, false).front();
            const double error = ranked_error(proof, full);
            fmt::print("{}: relative RMSE {:.3g} at {} × {}, {} {:g}; {:.3g} s.\n", name_of(chosen), error,
                       full.width, full.height, error <= target ? "within" : "above", target,
                       proof.seconds.median);
            if (error <= target) return done;
            std::erase_if(left, [&](const Measured& m) { return m.configuration == chosen; });
        }
        fmt::print(stderr, "rayscope: no configuration comes within a relative RMSE of {:g}\n", target);
        return failed;
    }

    const AccuracyCommandOptions& options_;
    std::filesystem::path path_;
    Scene scene_;
    std::vector<Configuration> configurations_;
};

} // namespace

int accuracy(const AccuracyCommandOptions& options) {
    try {
        return AccuracyCommand(options).run();
    } catch (const Stopped&) {
        std::fputs("rayscope: stopped; the reference is kept as far as it came, the same command goes on "
                   "from there\n",
                   stderr);
        return interrupted;
    }
}

} // namespace rayscope::cli
