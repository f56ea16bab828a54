// rayscope step: one ray's recursion as text, a picture, and on a terminal a conversation.

#include "visualizer/cli/commands.hpp"
#include "visualizer/cli/compare_text.hpp"
#include "visualizer/cli/conversation.hpp"
#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/output_check.hpp"
#include "visualizer/cli/picture_process.hpp"
#include "visualizer/cli/scene_choice.hpp"
#include "visualizer/cli/session.hpp"
#include "visualizer/cli/step_text.hpp"
#include "visualizer/cli/warnings.hpp"
#include "visualizer/cli/why_text.hpp"

#include <cstdio>

#include <unistd.h>

namespace rayscope::cli {
namespace {

std::string title(const Trace& trace, const StepStyle& style, bool comparing) {
    const TraceSource& source = trace.source;
    std::string ray =
        source.by_hand ? "a ray given by hand"
                       : "pixel (" + std::to_string(source.x) + "," + glue + std::to_string(source.y) + ")";
    if (source.sample > 0) ray += ", sample " + std::to_string(source.sample);
    Page page(style.paint);
    page.line(style.paint.bold(harmless(source.scene)) + ", " + ray);
    if (comparing) return page.text();
    page.line("max_depth" + std::string(glue) + std::to_string(trace.max_depth) + ", min_weight" + glue +
              style.number(trace.min_weight) + "; a colour given as one number is a grey");
    page.gap();
    return page.text();
}

void print(const std::string& text) {
    std::fputs(text.c_str(), stdout);
    std::fflush(stdout); // the picture comes later
}

/// Without --png a missing picture is no error: the text is the answer.
void add_picture(const Trace& trace, const StepOptions& options) {
    if (options.no_picture) return;
    if (!options.picture_asked_for) {
        try {
            check_output("the picture", options.picture, {".png"});
        } catch (const UsageError& error) {
            std::fprintf(stderr, "rayscope: no picture: %s (--png FILE, --no-png)\n",
                         harmless(error.what()).c_str());
            return;
        }
        if (!can_draw()) {
            std::fprintf(stderr, "rayscope: no picture: %s\n", how_to_draw());
            return;
        }
    }
    if (options.all_steps) {
        print("\npictures:\n");
        draw(Drawing::pngs, trace, options.picture, options.size);
        return;
    }
    draw(Drawing::png, trace, options.picture, options.size);
    print("\npicture: " + harmless(options.picture) + "\n");
}

} // namespace

int step(const StepOptions& options) {
    if (options.picture_asked_for) {
        check_output("--png", options.picture, {".png"});
        if (!can_draw()) throw std::runtime_error(how_to_draw());
    }
    if (options.compare) (void)chosen_configuration("--compare", *options.compare, {});
    const Workbench bench =
        make_workbench(load_with_effects(find_scene(options.choice.scene), options.choice.effects));
    print_warnings(bench.scene);
    std::optional<std::size_t> asked_for;
    if (options.why) asked_for = find_drawn(bench.scene, *options.why);
    const Trace trace = trace_choice(bench, options.choice);
    const StepStyle style{Numbers(options.digits), Paint(wants_colours(STDOUT_FILENO))};
    const bool interactive = !options.script && isatty(STDIN_FILENO) == 1 && isatty(STDOUT_FILENO) == 1;

    if (asked_for) {
        print(why_list(bench, trace, *asked_for, style));
        if (options.picture_asked_for) add_picture(trace, options);
        return done;
    }
    if (options.compare) {
        const Configuration other =
            chosen_configuration("--compare", *options.compare, own_configuration(bench.scene));
        const Trace second = traced_again(bench, trace, other);
        const Configuration own = own_configuration(bench.scene);
        print(title(trace, style, true) +
              compare_text({name_of(own) + ": the scene's own", trace, own.numbers.scalar},
                           {name_of(other), second, other.numbers.scalar}, style));
        return done;
    }
    Session session(bench, trace, style, options.choice);
    if (options.json) return converse_in_json(session, options);
    print(title(trace, style, false) + tree_text(trace, style));
    if (options.quiz || options.script || (!interactive && input_waits())) {
        const int code = converse(session, options, interactive);
        if (options.picture_asked_for) add_picture(trace, options);
        return code;
    }
    if (interactive) {
        print(ray_text(trace, 0, style));
    } else {
        for (std::size_t ray = 0; ray < trace.rays.size(); ++ray) print(ray_text(trace, int(ray), style));
    }
    print(result_text(trace, style));
    add_picture(trace, options);
    if (interactive) converse_on_terminal(session);
    return done;
}

} // namespace rayscope::cli
