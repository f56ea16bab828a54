#include "exercises/grader/report_page.hpp"

#include "core/files/markup.hpp"
#include "core/scene/input_error.hpp"
#include "exercises/grader/ray_drawing.hpp"

#include <fmt/format.h>

namespace rayscope::exercises {
namespace {

constexpr const char* style =
    R"(body { font: 16px/1.5 system-ui, sans-serif; max-width: 46rem; margin: 2rem auto; padding: 0 1rem;
  color: #222; background: #fff; }
table { border-collapse: collapse; font-size: .9rem; } td, th { padding: .15rem .6rem; text-align: left; border-bottom: 1px solid #ccc; }
pre { background: #f4f4f4; padding: .6rem; white-space: pre-wrap; }
code, pre { overflow-wrap: anywhere; }
.says { border-left: 4px solid #b33; padding-left: .8rem; }
svg { width: 100%; font-size: 12px; } svg line { stroke: #999; } svg .start { stroke: #b33; stroke-dasharray: 3 3; }
svg rect { fill: #3779b8; } svg text { fill: #222; }
@media (prefers-color-scheme: dark) { body { color: #ddd; background: #181818; } pre { background: #262626; } svg text { fill: #ddd; } }
)";

std::string groups_table(const ExerciseMark& exercise) {
    std::string text = "<table><tr><th>group</th><th>points</th><th>cases</th></tr>\n";
    for (const GroupMark& group : exercise.groups)
        text +=
            fmt::format("<tr><td>{}{}</td><td>{} of {}</td><td>{} of {}</td></tr>\n", in_markup(group.name),
                        group.hidden ? " (hidden)" : "", group.score, group.points, group.right, group.cases);
    return text + "</table>\n";
}

std::string exercise_section(const ExerciseMark& exercise, const std::filesystem::path& rays) {
    std::string text = fmt::format("<h2>{} {}: {} of {}</h2>\n", in_markup(exercise.id),
                                   in_markup(exercise.title), exercise.score, exercise.points);
    if (!exercise.handed_in) return text + "<p>Not handed in.</p>\n";
    if (!exercise.compiled)
        return text + "<p>It does not compile.</p>\n<pre>" + in_markup(exercise.problem) + "</pre>\n";
    text += groups_table(exercise);
    if (!exercise.says.empty()) text += "<p class=\"says\">" + in_markup(exercise.says) + "</p>\n";
    for (const GroupMark& group : exercise.groups)
        if (!group.hidden && group.right < group.cases) {
            text +=
                fmt::format("<h3>{}</h3>\n<pre>{}</pre>\n", in_markup(group.name), in_markup(group.output));
            break;
        }
    if (!exercise.ray) return text;
    const std::string file = exercise.id + ".toml";
    try {
        text += "<h3>The ray of this case, as it is right</h3>\n" + drawn_ray(rays / file, exercise.ray->ray);
        text += fmt::format("<p>Step through it: <code>rayscope step rays/{} --ray={}</code></p>\n",
                            in_markup(file), in_markup(exercise.ray->ray));
    } catch (const InputError&) {
        text += "<p>No scene shows this case.</p>\n"; // a box without volume, say
    }
    return text;
}

} // namespace

std::string report_page(const SubmissionMark& mark, const std::filesystem::path& rays) {
    std::string text =
        fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
                    "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n{1}</style></head>\n"
                    "<body>\n<h1>{0}</h1>\n<p>{2} of {3} points.</p>\n",
                    in_markup(mark.student), style, mark.score, mark.points);
    for (const ExerciseMark& exercise : mark.exercises) text += exercise_section(exercise, rays);
    return text + "</body></html>\n";
}

} // namespace rayscope::exercises
