#include "exercises/grader/units.hpp"

#include "core/scene/source_text.hpp"

#include <fmt/format.h>

#include <regex>
#include <sstream>

namespace rayscope::exercises {
namespace {

constexpr std::size_t most_code = std::size_t(1) << 20U;

std::string declarations(const Exercise& exercise) {
    std::string text;
    for (const Function& function : exercise.functions) text += function.signature + ";\n";
    return text;
}

std::string function_names(const Exercise& exercise, const std::string& scope) {
    std::string text;
    for (const Function& function : exercise.functions) text += ", " + scope + function.name;
    return text;
}

/// Includes of the system's headers go in front, since the rest stands in a namespace.
void take_includes(const std::string& code, std::string& includes, std::string& rest) {
    static const std::regex include(R"re(^\s*#\s*include\s*<[\w./]{1,100}>.{0,200}$)re");
    std::istringstream lines(code);
    for (std::string line; std::getline(lines, line);) {
        const bool hoist = line.size() < 400 && std::regex_match(line, include);
        if (hoist) includes += line + "\n";
        rest += (hoist ? "" : line) + "\n";
    }
}

} // namespace

std::string read_code(const std::filesystem::path& path) { return read_file(path, most_code); }

Unit answer_unit(const Exercise& exercise, const std::string& code, bool sanitized) {
    Unit unit;
    unit.about = exercise.file_name();
    unit.sanitized = sanitized;
    // Declared and called before the student's file is read, so that no macro of it reaches this.
    unit.files.push_back(
        {"unit.cpp", fmt::format("#include \"rx.hpp\"\n#include \"wire.hpp\"\nusing namespace rx;\n{}"
                                 "void rx_answer(wire::Reader& in, wire::Writer& out) {{\n"
                                 "    wire::answer(in, out{});\n}}\n#include \"{}\"\n",
                                 declarations(exercise), function_names(exercise, "::"), unit.about)});
    unit.files.push_back({unit.about, code});
    // Leaks are looked for by a second process, which the sandbox does not let look.
    if (sanitized)
        unit.files.front().text +=
            "extern \"C\" const char* __asan_default_options() { return \"detect_leaks=0\"; }\n";
    return unit;
}

Unit reference_unit(const Exercise& exercise) {
    std::vector<Variant> variants{{"solution.hpp", read_code(exercise.solution())}};
    for (const Misconception& wrong : exercise.misconceptions)
        variants.push_back({"misconceptions/" + wrong.name + ".hpp", read_code(wrong.file)});
    return variants_unit(exercise, variants);
}

Unit variants_unit(const Exercise& exercise, const std::vector<Variant>& variants) {
    Unit unit;
    unit.about = "cases.cpp";
    unit.reference = true;
    std::string includes, body, choice;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        std::string code;
        take_includes(variants[i].code, includes, code);
        body += fmt::format("namespace rx_variant_{} {{\n{}#line 1 \"{}\"\n{}\n}}\n", i,
                            declarations(exercise), variants[i].name, code);
        choice += fmt::format("    case {}: return wire::answer(in, out{});\n", i,
                              function_names(exercise, fmt::format("rx_variant_{}::", i)));
    }
    std::string cases;
    take_includes(read_code(exercise.cases()), includes, cases);
    std::string text = "#include \"rx.hpp\"\n#include \"cases.hpp\"\n" + includes + "using namespace rx;\n" +
                       body + "#line 1 \"cases.cpp\"\n" + cases + "\n#line 1 \"calls\"\n";
    text += "void rx_cases(Cases& made) { cases(made); }\n";
    text += "void rx_answer(int variant, wire::Reader& in, wire::Writer& out) {\n    switch (variant) {\n" +
            choice + "    }\n}\n";
    const auto optional = [&](bool there, const char* name, const std::string& functions) {
        text +=
            there
                ? fmt::format("void {}(wire::Reader& in, wire::Writer& out) {{ wire::answer(in, out{}); }}\n",
                              name, functions)
                : fmt::format("void {}(wire::Reader&, wire::Writer&) {{}}\n", name);
    };
    optional(exercise.judged, "rx_judge", ", ::judge");
    optional(exercise.shown, "rx_show",
             exercise.functions.size() == 1 ? ", ::show" : function_names(exercise, "::show_"));
    unit.files.push_back({"unit.cpp", text});
    return unit;
}

} // namespace rayscope::exercises
