#pragma once
// Which options each command has.

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace rayscope::cli {

/// The options as texts: they are checked after all of them are known. An empty one was given, and is wrong.
struct Texts {
    using Text = std::optional<std::string>;
    Text scene, pixel, ray, digits, png, size, output, threads, statistics, why, compare, stage, heat;
    Text effects, samples, sample, script, where, listed, other;
    Text configurations, target_error, runs, reference_rays;
    bool no_png = false, all_steps = false, cases = false, cost = false, energy = false, even_samples = false,
         json = false, quiz = false;
};

/// Each on its own while it parses: below a common parent, a scene called like a command would be taken for one.
using Commands = std::vector<CLI::App_p>;

inline constexpr const char* scene_help = "scene file (.toml, .nff), or the name of a scene that ships";

/// All commands; what is given to them lands in `texts`, which must outlive them.
[[nodiscard]] Commands make_commands(Texts& texts);

} // namespace rayscope::cli
