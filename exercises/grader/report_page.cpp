#include "exercises/grader/report_page.hpp"

#include "core/files/markup.hpp"
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

std::string ray_section(const std::string& id, const ShownRay& ray) {
    std::string text = "<h3>The ray of this case</h3>\n";
    if (!ray.note.empty()) text += "<p>" + in_markup(ray.note) + "</p>\n";
    const std::string command =
        ray.yours.empty()
            ? fmt::format("rayscope step rays/{}.toml --ray={}", id, ray.ray)
            : fmt::format("rayscope diff rays/{0}.toml rays/{0}.yours.toml --ray={1}", id, ray.ray);
    return text + ray.drawing + "<p>Step through it: <code>" + in_markup(command) + "</code></p>\n";
}

std::string exercise_section(const ExerciseMark& exercise) {
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
    if (exercise.ray) text += ray_section(exercise.id, *exercise.ray);
    return text;
}

} // namespace

std::string report_page(const SubmissionMark& mark) {
    std::string text = fmt::format(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>\n"
        "<meta name=\"viewport\" content=\"width=device-width\">\n<style>\n{4}{1}</style></head>\n"
        "<body>\n<h1>{0}</h1>\n<p>{2} of {3} points.</p>\n",
        in_markup(mark.student), style, mark.score, mark.points, ray_drawing_style);
    for (const ExerciseMark& exercise : mark.exercises) text += exercise_section(exercise);
    return text + "</body></html>\n";
}

} // namespace rayscope::exercises
