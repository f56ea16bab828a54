#include "exercises/program/options.hpp"

#include "exercises/program/failure.hpp"

#include <CLI/CLI.hpp>

namespace rayscope::exercises {
namespace {

constexpr const char* overview =
    R"(Exercises: write a function, see whether it is right, and the ray that shows why not.

Without a command: watches your files and checks on every save. Start with:  ./rayscope exercises start)";

constexpr const char* names = "NAME is 1-03-sphere, 1-03 or sphere";

void add_student_commands(CLI::App& app, Options& options) {
    const auto command = [&](const char* name, const char* about, auto value) {
        CLI::App* const sub = app.add_subcommand(name, about);
        const auto kept = std::make_shared<decltype(value)>(std::move(value));
        sub->final_callback([&options, kept] { options.command = *kept; });
        sub->footer(names);
        return std::pair{sub, kept};
    };
    {
        const auto [sub, value] =
            command("start", "copy the stubs into a folder of your own; never overwrites", Start{});
        sub->add_option("DIR", value->folder, "the folder (default: rayscope-exercises)");
    }
    command("list", "all exercises, with your points", ListExercises{});
    {
        const auto [sub, value] = command("check", "check one exercise", Check{});
        sub->add_option("NAME", value->name, "the exercise, or a file of yours")->required();
    }
    command("check-all", "check all exercises", CheckAll{});
    {
        const auto [sub, value] = command("hint", "one hint more each time", Hint{});
        sub->add_option("NAME", value->name, "the exercise (default: the next one)");
    }
    {
        const auto [sub, value] = command("reset", "back to the stub; your file is kept beside it", Reset{});
        sub->add_option("NAME", value->name, "the exercise")->required();
        sub->add_flag("--yes", value->yes, "don't ask");
    }
    {
        const auto [sub, value] = command("solution", "our solution, once yours is right", ShowSolution{});
        sub->add_option("NAME", value->name, "the exercise")->required();
    }
    command("next", "the task of the next exercise", Next{});
    {
        const auto [sub, value] = command("predict", "answer first, then see why", Predict{});
        sub->add_option("NAME", value->name, "the exercise (default: the next one)");
    }
}

/// What `rayscope render` and `rayscope step` become with --with.
void add_formula_commands(CLI::App& app, Options& options) {
    const char* with = "the exercise whose function stands in place of ours: your file of it, or a path";
    {
        CLI::App* const sub =
            app.add_subcommand("render", "the image that your function makes, beside the right one");
        const auto value = std::make_shared<RenderWith>();
        sub->add_option("SCENE", value->scene, "a scene file, or the name of a shipped one")->required();
        sub->add_option("--with", value->with, with)->required();
        sub->add_option("-o,--output", value->output, "the image (default: rayscope-with.png)");
        sub->add_option("--size", value->size, "WxH of each of the three panels");
        sub->final_callback([&options, value] { options.command = *value; });
    }
    {
        CLI::App* const sub =
            app.add_subcommand("step", "where a ray with your function and one with ours part");
        const auto value = std::make_shared<StepWith>();
        sub->add_option("SCENE", value->scene, "a scene file, or the name of a shipped one")->required();
        sub->add_option("--with", value->with, with)->required();
        CLI::Option* const pixel = sub->add_option("--pixel", value->pixel, "X,Y (default: the centre)");
        sub->add_option("--ray", value->ray, "ox,oy,oz,dx,dy,dz")->excludes(pixel);
        sub->add_option("--size", value->size, "WxH of the image that the pixel belongs to");
        sub->final_callback([&options, value] { options.command = *value; });
    }
}

void add_instructor_commands(CLI::App& app, Options& options) {
    const auto command = [&](const char* name, const char* about, auto value) {
        CLI::App* const sub = app.add_subcommand(name, about);
        const auto kept = std::make_shared<decltype(value)>(std::move(value));
        sub->final_callback([&options, kept] { options.command = *kept; });
        return std::pair{sub, kept};
    };
    {
        const auto [sub, value] = command("verify", "prove that exercises test what they say", Verify{});
        sub->add_option("NAME", value->names, "the exercises (default: all)");
        sub->add_option("--seeds", value->seeds, "how many seeds")->check(CLI::Range(1, 10000));
        sub->add_option("--jobs", value->jobs, "how many at once")->check(CLI::Range(1, 256));
    }
    {
        const auto [sub, value] =
            command("grade", "grade submissions: results.json, JUnit, class table, pages", GradeAll{});
        sub->add_option("SUBMISSION", value->submissions, "a file, a student's folder, or a folder of such")
            ->required();
        sub->add_option("--exercise", value->exercises,
                        "which exercises (default: all that anybody handed in)");
        sub->add_option("-o,--output", value->output, "the folder for the results")->required();
        sub->add_option("--jobs", value->jobs, "how many at once")->check(CLI::Range(1, 256));
    }
    {
        const auto [sub, value] =
            command("package", "a Gradescope autograder, or with --student a workspace", Package{});
        sub->add_flag("--student", value->student, "the workspace that students get, without solutions");
        sub->add_option("--exercise", value->exercises, "which exercises are graded (default: all)");
        sub->add_option("-o,--output", value->output, "the .zip file")->required();
    }
    {
        const auto [sub, value] = command("new", "a new exercise, with all files to fill in", New{});
        sub->add_option("DIR", value->folder, "its folder, named like 1-07-torus")->required();
        CLI::Option* const trace = sub->add_option("--from-trace", value->trace, "a recorded trace (.json)");
        sub->add_option("--event", value->event, "the number of an event in it")->needs(trace);
    }
}

} // namespace

Options parse_options(int count, const char* const* arguments) {
    Options options;
    options.command = Watch{};
    CLI::App app(overview, "rayscope exercises");
    app.require_subcommand(0, 1);
    app.fallthrough();
    app.add_flag("--unsafe", options.unsafe, "without a sandbox, where the system allows none");
    app.add_flag("--instructor", options.instructor, "show solutions and hidden cases");
    app.add_option("--seed", options.seed, "makes the cases: another seed, other numbers (default 1)")
        ->check(CLI::NonNegativeNumber);
    app.add_option("--workspace", options.workspace, "the folder that start made (default: found from here)");
    app.add_option("--exercises", options.catalogue, "a folder with exercises of your own");
    add_student_commands(app, options);
    add_instructor_commands(app, options);
    add_formula_commands(app, options);
    try {
        app.parse(count, arguments);
    } catch (const CLI::CallForHelp&) {
        options.command = Help{app.help()};
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    return options;
}

} // namespace rayscope::exercises
