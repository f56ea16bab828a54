#include "visualizer/cli/scene_choice.hpp"

#include "visualizer/cli/failure.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>

namespace rayscope::cli {
namespace fs = std::filesystem;
namespace {

/// Where the scenes lie that ship: the environment variable RAYSCOPE_SCENES, else the source's chapters.
fs::path scenes_folder() {
    const char* given = std::getenv("RAYSCOPE_SCENES");
    return given != nullptr && *given != '\0' ? given : RAYSCOPE_SCENES;
}

/// Shipped scenes by name.
std::map<std::string, fs::path, std::less<>> shipped_scenes() {
    std::map<std::string, fs::path, std::less<>> scenes;
    std::error_code error;
    for (fs::recursive_directory_iterator at(scenes_folder(), error), end; !error && at != end;
         at.increment(error)) {
        const fs::path& path = at->path();
        if (path.extension() == ".toml" || path.extension() == ".nff")
            scenes.emplace(path.stem().string(), path);
    }
    return scenes;
}

/// As a person in the current folder would write it: messages stay short.
fs::path seen_from_here(const fs::path& path) {
    std::error_code error;
    const fs::path relative = fs::proximate(path, error);
    return error || relative.empty() || *relative.begin() == ".." ? path : relative;
}

/// A folder may have the name of a shipped scene. Of what can't be looked at, the reader says why.
bool means_file(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return fs::is_regular_file(status) || fs::is_fifo(status) || status.type() == fs::file_type::none ||
           (fs::exists(status) && path.has_extension());
}

} // namespace

fs::path find_scene(const std::string& text) {
    if (means_file(text)) return text;
    const std::string name = text.empty() ? "glass_bowl" : text;
    const auto scenes = shipped_scenes();
    if (const auto found = scenes.find(name); found != scenes.end()) return seen_from_here(found->second);
    std::vector<std::string_view> names;
    for (const auto& [stem, path] : scenes) names.push_back(stem);
    const std::string near = did_you_mean(name, names);
    throw UsageError("no scene file " + in_quotes(name) +
                     (!near.empty()   ? near
                      : names.empty() ? ", and no scenes in " + scenes_folder().string()
                                      : "; scenes that ship: " + one_of(names)));
}

Scene load_with_effects(const std::filesystem::path& path, const std::optional<std::string>& effects) {
    try {
        return load_scene(path, effects);
    } catch (const std::invalid_argument& error) {
        throw UsageError(std::string("--effects: ") + error.what());
    }
}

Trace trace_choice(const Workbench& bench, const RayChoice& choice) {
    std::shared_ptr<const StageSet> stages;
    if (choice.by_stage) stages = make_stages(bench, choice.stage);
    if (choice.ray) return stages ? trace_ray(bench, *stages, *choice.ray) : trace_ray(bench, *choice.ray);
    const Camera& camera = bench.scene.camera;
    const auto middle = std::pair(camera.width / 2, camera.height / 2);
    const auto [x, y] = choice.pixel.value_or(bench.scene.step_pixel.value_or(middle));
    if (x >= camera.width || y >= camera.height)
        throw UsageError("--pixel " + std::to_string(x) + "," + std::to_string(y) +
                         " lies outside the image of " + std::to_string(camera.width) + " × " +
                         std::to_string(camera.height) + " pixels, whose last one is " +
                         std::to_string(camera.width - 1) + "," + std::to_string(camera.height - 1));
    if (choice.sample >= camera.samples)
        std::fprintf(
            stderr,
            "rayscope: the scene takes %d sample%s of a pixel at most: number %d is in no image without "
            "larger --samples\n",
            camera.samples, camera.samples == 1 ? "" : "s", choice.sample);
    return stages ? trace_pixel(bench, *stages, x, y, 0, 0, choice.sample)
                  : trace_pixel(bench, x, y, 0, 0, choice.sample);
}

} // namespace rayscope::cli
