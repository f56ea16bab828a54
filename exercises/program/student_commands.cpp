// What students do, one command after the other.

#include "core/scene/source_text.hpp"
#include "exercises/grader/units.hpp"
#include "exercises/program/checking.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/overview.hpp"
#include "exercises/program/screen.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <iostream>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

void print(const std::string& text) { std::fputs(text.c_str(), stdout); }

} // namespace

int run(const Context& context, const Start& command) {
    const fs::path folder =
        command.folder ? fs::absolute(*command.folder).lexically_normal() : default_workspace();
    const auto written = start_workspace(folder, context.catalogue);
    print(
        fmt::format("{}: {} files are new, all others stay as they are.\n", folder.string(), written.size()));
    print("Getting the compiler ready …\n");
    (void)make_toolchain(context);
    print(fmt::format("\nOpen {} in your editor, and let  {} exercises  watch.\n",
                      (folder / context.catalogue.front().file_name()).string(), launcher()));
    return done;
}

int run(const Context& context, const ListExercises&) {
    const Workspace workspace = find_workspace(context.options.workspace);
    print(list_text(context.catalogue, workspace.progress(), Screen::of_stdout()));
    return done;
}

int run(const Context& context, const Check& command) {
    const bool is_file = fs::is_regular_file(command.name);
    const Exercise& exercise =
        find_exercise(context.catalogue, is_file ? fs::path(command.name).stem().string() : command.name);
    std::optional<Workspace> workspace;
    if (!is_file || context.options.workspace) workspace = find_workspace(context.options.workspace);
    const auto toolchain = make_toolchain(context);
    const Checked checked =
        check(context, *toolchain, exercise, is_file ? fs::path(command.name) : workspace->file(exercise),
              workspace ? &*workspace : nullptr);
    print(checked.text);
    return checked.grade.all_right() ? done : failed;
}

int run(const Context& context, const CheckAll&) {
    const Workspace workspace = find_workspace(context.options.workspace);
    const auto toolchain = make_toolchain(context);
    bool all = true;
    for (const Exercise& exercise : context.catalogue) {
        const Checked checked = check(context, *toolchain, exercise, workspace.file(exercise), &workspace);
        all = all && checked.grade.all_right();
        print(fmt::format("{:<6} {:<20} {:>6} of {} points\n", checked.grade.all_right() ? "right" : "",
                          exercise.id, points_text(checked.grade.score), exercise.points));
        std::fflush(stdout);
    }
    print(summary_text(context.catalogue, workspace.progress()));
    return all ? done : failed;
}

int run(const Context& context, const Hint& command) {
    const Workspace workspace = find_workspace(context.options.workspace);
    const Exercise* exercise = command.name ? &find_exercise(context.catalogue, *command.name)
                                            : next_exercise(context.catalogue, workspace.progress());
    if (exercise == nullptr) exercise = &context.catalogue.back();
    print(hint_text(*exercise, workspace));
    return done;
}

int run(const Context& context, const Reset& command) {
    const Workspace workspace = find_workspace(context.options.workspace);
    const Exercise& exercise = find_exercise(context.catalogue, command.name);
    if (!command.yes) {
        print(fmt::format("Put {} back to the stub? Your file is kept beside it. [y/N] ",
                          exercise.file_name()));
        std::fflush(stdout);
        std::string answer;
        if (!std::getline(std::cin, answer) || (answer != "y" && answer != "yes")) {
            print("Nothing was changed.\n");
            return failed;
        }
    }
    print(reset_text(exercise, workspace));
    return done;
}

int run(const Context& context, const ShowSolution& command) {
    const Exercise& exercise = find_exercise(context.catalogue, command.name);
    if (!context.options.instructor) {
        const Progress progress = find_workspace(context.options.workspace).progress();
        const auto known = progress.find(exercise.id);
        if (known == progress.end() || !known->second.passed) {
            std::fprintf(stderr,
                         "rayscope: the solution is shown once yours is right:  %s exercises check %s\n",
                         launcher().c_str(), exercise.id.c_str());
            return failed;
        }
    }
    print(read_code(exercise.solution()));
    return done;
}

int run(const Context& context, const Next&) {
    const Workspace workspace = find_workspace(context.options.workspace);
    print(next_text(context.catalogue, workspace));
    return done;
}

int run(const Context& context, const Predict& command) {
    const Exercise* exercise = nullptr;
    if (command.name)
        exercise = &find_exercise(context.catalogue, *command.name);
    else
        exercise = next_exercise(context.catalogue, find_workspace(context.options.workspace).progress());
    if (exercise == nullptr || exercise->predictions.empty()) {
        print("There is nothing to predict.\n");
        return done;
    }
    bool all = true;
    for (const Prediction& prediction : exercise->predictions) {
        print(wrapped(prediction.question, 0) + "> ");
        std::fflush(stdout);
        std::string answer;
        if (!std::getline(std::cin, answer) || answer.find_first_not_of(" \t\r") == std::string::npos) {
            print("\nAn answer first; then you see why.\n");
            return failed;
        }
        const bool right = predicted(prediction, answer);
        all = all && right;
        print((right ? "Right: " : "No: ") + prediction.answer + "\n" + wrapped(prediction.reveal, 0));
    }
    return all ? done : failed;
}

} // namespace rayscope::exercises
