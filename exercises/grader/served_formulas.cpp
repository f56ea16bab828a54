#include "exercises/grader/served_formulas.hpp"

#include "exercises/grader/child.hpp"
#include "exercises/grader/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace rayscope::exercises {
namespace {

constexpr std::chrono::seconds patience{5};
constexpr std::uint32_t largest_answer = 1U << 20U;

/// The student's program, which answers call after call.
class Server {
public:
    Server(const Toolchain& toolchain, const Exercise& exercise, const std::filesystem::path& program,
           std::chrono::seconds in_all)
        : name_(exercise.functions.front().name),
          end_(std::chrono::steady_clock::now() + in_all),
          child_(command(toolchain, program), {}, Child::Errors::kept_apart) {}

    [[nodiscard]] Value call(const List& arguments) {
        std::string call = encoded({std::int64_t(0)}); // the exercise's first function
        for (const Value& argument : arguments) call += encoded(argument);
        const auto size = std::uint32_t(call.size());
        std::string request(reinterpret_cast<const char*>(&size), sizeof size);
        if (!child_.write(request + call)) fail();
        const auto length = child_.read(sizeof size, time_left());
        if (!length) fail();
        std::uint32_t count = 0;
        std::memcpy(&count, length->data(), sizeof count);
        if (count > largest_answer) fail();
        const auto answer = child_.read(count, time_left());
        auto value = answer ? decoded(*answer) : std::nullopt;
        if (!value) fail();
        return std::move(*value);
    }
    [[noreturn]] void fail() const {
        throw std::runtime_error(
            fmt::format("{}() gives no answer: it is not written yet, crashed, or takes too long. Check "
                        "the exercise first",
                        name_));
    }

private:
    static std::vector<std::string> command(const Toolchain& toolchain,
                                            const std::filesystem::path& program) {
        if (toolchain.safety() == Safety::unsafe)
            return {toolchain.runner().string(), program.string(), "serve"};
        return confined({{toolchain.runner(), "/runner"}, {program, "/program"}},
                        {"/runner", "/program", "serve"});
    }

    [[nodiscard]] std::chrono::milliseconds time_left() const {
        using std::chrono::milliseconds;
        const auto left = std::chrono::duration_cast<milliseconds>(end_ - std::chrono::steady_clock::now());
        return std::clamp(left, milliseconds(0), milliseconds(patience));
    }

    std::string name_;
    std::chrono::steady_clock::time_point end_;
    Child child_;
};

Value value_of(const Vec3d& v) { return {Record{"dvec3", {{"x", {v.x}}, {"y", {v.y}}, {"z", {v.z}}}}}; }
Value value_of(const Mat4d& m) {
    Record columns{"dmat4", {}};
    for (int i = 0; i < 4; ++i)
        columns.fields.push_back(
            {"", Value{Record{"dvec4",
                              {{"x", {m[i][0]}}, {"y", {m[i][1]}}, {"z", {m[i][2]}}, {"w", {m[i][3]}}}}}});
    return {std::move(columns)};
}
Value value_of(const Ray<double>& ray) {
    return {Record{"Ray", {{"o", value_of(ray.origin)}, {"d", value_of(ray.direction)}}}};
}
Value value_of(const std::vector<FormulaHit>& hits) {
    List list;
    for (const FormulaHit& hit : hits)
        list.push_back({Record{"Hit",
                               {{"t", {hit.t}},
                                {"n", value_of(hit.normal)},
                                {"enter", {hit.entering}},
                                {"obj", {std::int64_t(hit.source)}}}}});
    return {std::move(list)};
}

// What comes back has the declared type, or else the program was made to cheat: std::bad_variant_access, and at(),
// end the render like any other failure.
const Value& field(const Value& record, std::size_t index) {
    return std::get<Record>(record.content).fields.at(index).value;
}
double number(const Value& value) {
    const double result = std::get<double>(value.content);
    if (std::isnan(result)) throw std::runtime_error("the function's answer is not a number (NaN)");
    return result;
}
Vec3d vector(const Value& value) {
    return {number(field(value, 0)), number(field(value, 1)), number(field(value, 2))};
}

} // namespace

std::vector<const Exercise*> with_formulas(const std::vector<Exercise>& catalogue) {
    std::vector<const Exercise*> list;
    for (const Exercise& exercise : catalogue)
        if (!exercise.formula.empty()) list.push_back(&exercise);
    return list;
}

Formulas served_formulas(const Toolchain& toolchain, const Exercise& exercise,
                         const std::filesystem::path& program, std::chrono::seconds in_all) {
    const auto server = std::make_shared<Server>(toolchain, exercise, program, in_all);
    Formulas formulas;
    if (exercise.formula == "mirror")
        formulas.mirror = [server](const Vec3d& p, const Vec3d& d, const Vec3d& n) {
            return vector(server->call({value_of(p), value_of(d), value_of(n)}));
        };
    if (exercise.formula == "refract")
        formulas.refract = [server](const Vec3d& d, const Vec3d& n, double c1,
                                    double c2) -> std::optional<Vec3d> {
            const Value answer = server->call({value_of(d), value_of(n), {c1}, {c2}});
            if (std::holds_alternative<std::monostate>(answer.content)) return std::nullopt;
            return vector(answer);
        };
    if (exercise.formula == "worldNormal")
        formulas.normal = [server](const Vec3d& n, const Mat4d& matrix) {
            return vector(server->call({value_of(n), value_of(matrix)}));
        };
    if (exercise.formula == "sphere")
        formulas.sphere = [server](const Ray<double>& ray) {
            std::vector<std::pair<double, double>> spans;
            const Value answer = server->call({value_of(ray)});
            for (const Value& span : std::get<List>(answer.content))
                spans.emplace_back(number(field(span, 0)), number(field(span, 1)));
            return spans;
        };
    if (exercise.formula == "difference")
        formulas.difference = [server](const std::vector<FormulaHit>& a, const std::vector<FormulaHit>& b) {
            std::vector<FormulaHit> hits;
            const Value answer = server->call({value_of(a), value_of(b)});
            for (const Value& hit : std::get<List>(answer.content))
                hits.push_back({number(field(hit, 0)), vector(field(hit, 1)),
                                std::get<bool>(field(hit, 2).content),
                                int(std::get<std::int64_t>(field(hit, 3).content))});
            return hits;
        };
    if (exercise.formula == "toObject")
        formulas.to_object = [server](const Ray<double>& ray, const Mat4d& matrix) -> Ray<double> {
            const Value answer = server->call({value_of(ray), value_of(matrix)});
            return {vector(field(answer, 0)), vector(field(answer, 1))};
        };
    if (exercise.formula == "wall")
        formulas.wall = [server](const Vec3d& d, const Vec3d& outward, double speed) -> FormulaWall {
            const Value answer = server->call({value_of(d), value_of(outward), {speed}});
            const auto flag = [&](std::size_t i) { return std::get<bool>(field(answer, i).content); };
            return {vector(field(answer, 0)), number(field(answer, 1)), number(field(answer, 2)), flag(3),
                    flag(4)};
        };
    if (exercise.formula == "fresnel")
        formulas.fresnel = [server](double speed_from, double speed_to, double cosine) {
            return number(server->call({{speed_from}, {speed_to}, {cosine}}));
        };
    return formulas;
}

} // namespace rayscope::exercises
