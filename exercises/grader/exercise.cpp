#include "exercises/grader/exercise.hpp"

#include "core/scene/toml_guard.hpp"
#include "core/scene/toml_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <regex>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_bytes = std::size_t(1) << 20U;
constexpr int most_points = 1000;

std::string need_file(const fs::path& path) { return read_file(path, most_bytes); }

std::vector<std::string> strings(const TomlTable& table, std::string_view key) {
    std::vector<std::string> result;
    if (const auto value = table.find(key))
        for (const TomlValue& item : value->list()) result.emplace_back(item.string());
    return result;
}

std::vector<TomlTable> tables(const TomlTable& table, std::string_view key) {
    std::vector<TomlTable> result;
    if (const auto value = table.find(key))
        for (const TomlValue& item : value->list()) result.push_back(item.table());
    return result;
}

Function read_function(const TomlValue& value) {
    static const std::regex name(R"re([\w:<>,&\s]*\b([A-Za-z_]\w*)\s*\([^(){};#"]*\))re");
    const std::string text(value.string());
    std::smatch match;
    if (!std::regex_match(text, match, name))
        value.fail("expected a function's signature, for example \"Spans sphere(const Ray& r)\"");
    return {text, match[1]};
}

Group read_group(const TomlTable& table, Place place) {
    table.allow_only("a group", {"name", "points", "hidden"});
    Group group;
    group.name = table.require("name", place, "name = \"basic\"").string();
    group.points = table.require("points", place, "points = 4").integer(1, most_points);
    if (const auto hidden = table.find("hidden")) group.hidden = hidden->boolean();
    return group;
}

Misconception read_misconception(const TomlTable& table, Place place, const Exercise& exercise) {
    table.allow_only("a misconception", {"name", "groups", "says"});
    Misconception wrong;
    const TomlValue name = table.require("name", place, "name = \"unit\"");
    wrong.name = name.string();
    wrong.says = table.require("says", place, "says = \"You renormalised d.\"").string();
    const TomlValue groups = table.require("groups", place, "groups = [\"edge\"]");
    for (const TomlValue& group : groups.list()) {
        wrong.groups.emplace_back(group.string());
        if (std::ranges::find(exercise.groups, wrong.groups.back(), &Group::name) == exercise.groups.end())
            group.fail(fmt::format("'{}' is no group of this exercise", wrong.groups.back()));
    }
    static const std::regex file_name("[a-z0-9][a-z0-9-]*");
    if (!std::regex_match(wrong.name, file_name)) name.fail("a name is of a-z, 0-9 and '-'");
    wrong.file = exercise.folder / "misconceptions" / (wrong.name + ".hpp");
    if (!fs::is_regular_file(wrong.file))
        name.fail(fmt::format("expected the wrong solution in misconceptions/{}.hpp", wrong.name));
    return wrong;
}

void read_tolerance(const TomlTable& table, Tolerance& tolerance) {
    const auto value = table.find("tolerance");
    if (!value) return;
    const TomlTable inner = value->table();
    inner.allow_only("a tolerance", {"absolute", "relative"});
    if (const auto absolute = inner.find("absolute")) tolerance.absolute = absolute->number(not_negative);
    if (const auto relative = inner.find("relative")) tolerance.relative = relative->number(from_0_to_1);
}

void read_toml_file(const SourceText& source, const toml::table& document, Exercise& exercise) {
    const TomlTable top(source, document, "");
    top.allow_only("an exercise",
                   {"title", "chapter", "points", "function", "functions", "prerequisites", "hints",
                    "picture", "scene", "formula", "tolerance", "group", "misconception", "predict"});
    top.allow_one("function", "functions");
    const Place start{1, 1};
    exercise.title = top.require("title", start, "title = \"Unit sphere\"").string();
    exercise.chapter = top.require("chapter", start, "chapter = 1").integer(0, 99);
    const TomlValue points = top.require("points", start, "points = 10");
    exercise.points = points.integer(1, most_points);
    if (const auto several = top.find("functions"))
        for (const TomlValue& one : several->list()) exercise.functions.push_back(read_function(one));
    else
        exercise.functions.push_back(
            read_function(top.require("function", start, "function = \"Spans sphere(const Ray& r)\"")));
    exercise.prerequisites = strings(top, "prerequisites");
    exercise.hints = strings(top, "hints");
    if (const auto picture = top.find("picture")) exercise.picture = picture->string();
    if (const auto scene = top.find("scene")) exercise.scene = scene->string();
    if (const auto formula = top.find("formula")) exercise.formula = formula->string();
    read_tolerance(top, exercise.tolerance);
    const Place groups = top.require("group", start, "[[group]]").place();
    for (const TomlTable& table : tables(top, "group")) exercise.groups.push_back(read_group(table, groups));
    const int sum = std::accumulate(exercise.groups.begin(), exercise.groups.end(), 0,
                                    [](int total, const Group& group) { return total + group.points; });
    if (sum != exercise.points)
        points.fail(fmt::format("the groups are worth {} points together, expected the same as here", sum));
    for (const TomlTable& table : tables(top, "misconception"))
        exercise.misconceptions.push_back(read_misconception(table, start, exercise));
    for (const TomlTable& table : tables(top, "predict")) {
        table.allow_only("a prediction", {"question", "answer", "reveal"});
        exercise.predictions.push_back(
            {std::string(table.require("question", start, "question = \"…?\"").string()),
             std::string(table.require("answer", start, "answer = \"2\"").string()),
             std::string(table.require("reveal", start, "reveal = \"Because …\"").string())});
    }
}

toml::table parsed(const SourceText& source) {
    source.reject_binary();
    guard_toml_parser(source);
    try {
        return toml::parse(source.text());
    } catch (const toml::parse_error& error) {
        const auto& begin = error.source().begin;
        source.fail({int(begin.line), int(begin.column)}, std::string(error.description()));
    }
}

} // namespace

Exercise read_exercise(const fs::path& folder) {
    Exercise exercise;
    exercise.folder = fs::absolute(folder).lexically_normal();
    if (!exercise.folder.has_filename()) exercise.folder = exercise.folder.parent_path();
    exercise.id = exercise.folder.filename();
    static const std::regex id("[0-9a-z]+(-[0-9a-z]+)*");
    if (!std::regex_match(exercise.id, id))
        throw InputError(folder.string(), {}, "the folder of an exercise is named like 1-01-to-object");
    const std::string text = need_file(folder / "exercise.toml");
    const SourceText source((folder / "exercise.toml").string(), text);
    const toml::table document = parsed(source);
    read_toml_file(source, document, exercise);
    for (const auto& path : {exercise.task(), exercise.stub(), exercise.solution()}) (void)need_file(path);
    const std::string cases = need_file(exercise.cases());
    exercise.judged = std::regex_search(cases, std::regex(R"re(std::string\s+judge\s*\()re"));
    exercise.shown = std::regex_search(cases, std::regex(R"re(Shown\s+show(_\w+)?\s*\()re"));
    return exercise;
}

std::vector<Exercise> read_catalogue(const fs::path& folder) {
    if (!fs::is_directory(folder)) throw InputError(folder.string(), {}, "expected a folder with exercises");
    std::vector<fs::path> folders;
    for (const auto& entry : fs::directory_iterator(folder))
        if (fs::is_regular_file(entry.path() / "exercise.toml")) folders.push_back(entry.path());
    std::ranges::sort(folders);
    std::vector<Exercise> catalogue;
    for (const fs::path& path : folders) catalogue.push_back(read_exercise(path));
    if (catalogue.empty()) throw InputError(folder.string(), {}, "no exercise is in this folder");
    return catalogue;
}

const Exercise& find_exercise(const std::vector<Exercise>& catalogue, const std::string& name) {
    static const std::regex number("^[0-9]+-[0-9]+-");
    std::vector<const Exercise*> found;
    for (const Exercise& exercise : catalogue) {
        if (exercise.id == name || std::regex_replace(exercise.id, number, "") == name) return exercise;
        if (!name.empty() && exercise.id.starts_with(name + "-")) found.push_back(&exercise);
    }
    if (found.size() == 1) return *found.front();
    std::string known;
    for (const Exercise& exercise : catalogue) known += (known.empty() ? "" : ", ") + exercise.id;
    throw InputError(name.empty() ? "NAME" : name, {},
                     fmt::format("{}; expected one of: {}",
                                 found.empty() ? "no such exercise" : "fits several exercises", known));
}

} // namespace rayscope::exercises
