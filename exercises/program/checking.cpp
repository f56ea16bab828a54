#include "exercises/program/checking.hpp"

#include "core/files/atomic_file.hpp"
#include "exercises/grader/shown_case.hpp"
#include "exercises/grader/units.hpp"
#include "exercises/program/feedback.hpp"

#include <fmt/format.h>

#include <future>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

std::string quoted(const fs::path& path) {
    std::string text = "'";
    for (const char c : path.string()) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Writes the scenes of the case and gives the command that opens its recorded ray.
std::optional<RayCommand> ray_command(const Toolchain& toolchain, const Checked& checked,
                                      const Compiled& compiled, const Workspace& workspace,
                                      bool show_hidden) {
    const Exercise& exercise = *checked.reference.exercise;
    const auto index = told_case(checked.reference, checked.grade, show_hidden);
    if (!index) return std::nullopt;
    const auto runs = shown_runs(toolchain, checked.reference, *index, checked.grade.cases[*index].outcome,
                                 compiled.program);
    if (!runs) {
        if (exercise.scene.empty()) return std::nullopt;
        return RayCommand{fmt::format("{} step {}", launcher(), exercise.scene),
                          "The case itself can't be drawn; this ray shows the same thing."};
    }
    const ShownCase& show = runs->shown;
    const fs::path folder = workspace.own_folder() / "rays";
    fs::create_directories(folder);
    const auto written = [&](const char* ending, const std::string& scene) {
        const fs::path file = folder / (exercise.id + ending);
        write_text_file(file, scene);
        return quoted(file);
    };
    const std::string right = written(".toml", show.scene), ray = text_of(show.ray);
    // Where the answer can be drawn, both runs are shown, up to where they part.
    if (runs->parted && !show.yours.empty())
        return RayCommand{
            fmt::format("{} diff {} {} --ray={}", launcher(), right, written(".yours.toml", show.yours), ray),
            "A is the right ray, B yours. " + show.note};
    if (runs->parted)
        return RayCommand{fmt::format("{} step {} --ray={} --with {}", launcher(), right, ray,
                                      quoted(workspace.file(exercise))),
                          show.note};
    const std::string stage = show.stage.empty() ? "" : " --stage " + show.stage;
    const char* yours =
        runs->yours ? " Your answer makes the same ray." : " It is the right one; your answer makes none.";
    return RayCommand{fmt::format("{} step {} --ray={}{}", launcher(), right, ray, stage), show.note + yours};
}

} // namespace

Checked check(const Context& context, const Toolchain& toolchain, const Exercise& exercise,
              const fs::path& file, const Workspace* workspace) {
    const std::string code = read_code(file);
    auto reference =
        std::async(std::launch::async, [&] { return make_reference(toolchain, exercise, context.seed()); });
    const PrivateFolder folder(toolchain.cache());
    const Compiled compiled = toolchain.compile(answer_unit(exercise, code), folder.path() / "program");
    Checked checked{reference.get(), {}, {}};
    checked.grade = grade(toolchain, checked.reference, compiled);
    Feedback feedback{context.options.instructor, code, std::nullopt};
    if (workspace != nullptr) {
        feedback.ray = ray_command(toolchain, checked, compiled, *workspace, feedback.show_hidden);
        workspace->update([&](Progress& progress) {
            Achievement& achievement = progress[exercise.id];
            achievement.best = std::max(achievement.best, checked.grade.score);
            achievement.passed = achievement.passed || checked.grade.all_right();
        });
    }
    checked.text = feedback_text(checked.reference, checked.grade, feedback, Screen::of_stdout());
    return checked;
}

} // namespace rayscope::exercises
