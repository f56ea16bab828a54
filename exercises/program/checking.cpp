#include "exercises/program/checking.hpp"

#include "core/files/atomic_file.hpp"
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

/// Writes the scene of the case and gives the command that opens its recorded ray.
std::optional<std::string> ray_command(const Toolchain& toolchain, const Checked& checked,
                                       const Workspace& workspace, bool show_hidden) {
    const Exercise& exercise = *checked.reference.exercise;
    const auto index = told_case(checked.reference, checked.grade, show_hidden);
    if (!index) return std::nullopt;
    if (const auto show = shown(toolchain, checked.reference, checked.reference.cases[*index])) {
        const fs::path folder = workspace.own_folder() / "rays";
        fs::create_directories(folder);
        const fs::path file = folder / (exercise.id + ".toml");
        write_text_file(file, show->scene);
        // Where the function stands for a formula of the tracer, both runs are shown, up to where they part.
        const std::string with =
            exercise.formula.empty() ? "" : fmt::format(" --with {}", quoted(workspace.file(exercise)));
        return fmt::format("{} step {} --ray={}{}", launcher(), quoted(file), show->ray, with);
    }
    if (exercise.scene.empty()) return std::nullopt;
    return fmt::format("{} step {}", launcher(), exercise.scene);
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
        feedback.ray = ray_command(toolchain, checked, *workspace, feedback.show_hidden);
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
