#pragma once
// What the command line says.

#include "core/rayscope.hpp"

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace rayscope::cli {

struct Size {
    int width = 0, height = 0;
};

/// Which ray of a scene is traced: that of a pixel, a given one, or, with neither, the scene's own choice.
struct RayChoice {
    std::string scene; ///< a path or the name of a shipped scene; empty: the glass bowl
    std::optional<std::pair<int, int>> pixel;
    std::optional<Ray<double>> ray;
    std::optional<std::string> effects; ///< as rayscope::parse_effects reads them
    int sample = 0;                     ///< of the pixel; 0 is its middle
    bool by_stage = false; ///< the trace tells where a stage looked for hits; else every object is tested
    std::optional<StageChoice> stage; ///< none: the quickest
};

struct StepOptions {
    RayChoice choice;
    int digits = 6;
    std::string picture = "rayscope-step.png";
    bool picture_asked_for = false, no_picture = false;
    bool all_steps = false;         ///< a picture for each ray
    std::optional<Size> size;       ///< of the picture
    std::optional<std::string> why; ///< the drawn object of which to tell only why the rays did not end on it
    std::optional<std::string>
        compare; ///< the configuration, as rayscope::configuration reads it, to compare with
    std::optional<std::string> script; ///< a file of commands; "-": standard input
    bool json = false, quiz = false;
};

struct FindCommandOptions {
    std::string scene, where;
    std::optional<Size> size;
    bool by_stage = false;
    std::optional<StageChoice> stage;  ///< none: the quickest
    std::optional<std::string> output; ///< the mask
    int threads = 0, listed = 12;
    bool json = false;
};

/// One of the three says what the second run is.
struct DiffOptions {
    RayChoice choice;
    std::optional<std::string> other;         ///< a scene
    std::optional<std::string> configuration; ///< as rayscope::configuration reads it
    std::optional<std::string> stage;
    int digits = 6;
};

struct TraceOptions {
    RayChoice choice;
    std::string output;
};

struct RenderCommandOptions {
    std::string scene, output;
    std::optional<std::string> statistics;
    std::optional<Size> size;
    std::optional<std::string> configuration; ///< as rayscope::configuration reads it
    std::optional<StageChoice> stage;         ///< none: the quickest
    std::optional<Heat> heat;           ///< the picture tells what each pixel costs, or who brings its light
    std::optional<std::string> effects; ///< as rayscope::parse_effects reads them
    int samples = 0;                    ///< at most so many in a pixel; 0: the scene's
    bool even_samples = false;          ///< as many in each
    int threads = 0;
};

struct ExplainOptions {
    std::string scene;
    std::optional<std::string> effects; ///< as rayscope::parse_effects reads them
    std::optional<Size> size;           ///< of the images that are made; without it a reduced one
    std::optional<std::string> output;  ///< a folder for pictures of what each effect changes
    bool cost = false, energy = false;
    int rounds = 5, threads = 0;
};

struct ExtentsOptions {
    std::string scene, output;
    std::optional<Size> size;
};

struct ExportOptions {
    std::string scene, output;
};

struct AccuracyCommandOptions {
    std::string scene;
    std::string configurations = "default"; ///< as rayscope::configurations reads them
    std::optional<std::string> output;      ///< a folder
    std::optional<Size> size;               ///< of the images; without it a reduced one
    std::optional<double> target_error;     ///< relative RMSE
    int runs = 5, threads = 0, reference_rays = 100000;
};

struct CasesOptions {
    std::optional<std::string> folder; ///< of case files; without it the shipped ones
    std::optional<std::string> output; ///< a folder
};

/// Help or the version, already answered: the text goes to stdout.
struct Help {
    std::string text;
};

using Options =
    std::variant<Help, StepOptions, FindCommandOptions, DiffOptions, TraceOptions, RenderCommandOptions,
                 ExplainOptions, ExtentsOptions, ExportOptions, AccuracyCommandOptions, CasesOptions>;

/// Throws UsageError.
[[nodiscard]] Options parse_options(int count, const char* const* arguments);

} // namespace rayscope::cli
