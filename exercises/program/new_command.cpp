// A new exercise: a small one that is right, or the shipped one that a recorded event belongs to, with that case.

#include "core/files/atomic_file.hpp"
#include "core/scene/input_error.hpp"
#include "exercises/grader/cut_case.hpp"
#include "exercises/grader/units.hpp"
#include "exercises/program/commands.hpp"
#include "exercises/program/failure.hpp"
#include "exercises/program/screen.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace rayscope::exercises {
namespace fs = std::filesystem;
namespace {

void copy_exercise(const fs::path& from, const fs::path& to) {
    fs::create_directories(to / "misconceptions");
    for (const auto& entry : fs::recursive_directory_iterator(from))
        if (entry.is_regular_file())
            write_text_file(to / entry.path().lexically_relative(from), read_code(entry.path()));
}

/// Puts the case in front of all others.
void add_case(const fs::path& file, const std::string& add) {
    std::string code = read_code(file);
    const std::string start = "void cases(Cases& c) {\n";
    const std::size_t at = code.find(start);
    if (at == std::string::npos) throw InputError(file.string(), {}, "expected void cases(Cases& c) in it");
    code.insert(at + start.size(), "    c.group(\"basic\");\n    " + add + "\n");
    write_text_file(file, code);
}

} // namespace

int run(const Context& context, const New& command) {
    if (fs::exists(fs::symlink_status(command.folder)))
        throw UsageError(command.folder.string() + " is there already; expected the name of a new folder");
    if (command.trace.has_value() != command.event.has_value())
        throw UsageError("--from-trace and --event belong together");
    fs::path from = fs::path(RAYSCOPE_EXERCISES) / "program/template";
    std::string add;
    if (command.trace) {
        const CutCase cut = cut_case(*command.trace, *command.event);
        from = find_exercise(context.catalogue, cut.exercise).folder;
        add = cut.add;
    }
    copy_exercise(from, command.folder);
    try {
        if (!add.empty()) add_case(command.folder / "cases.cpp", add);
        (void)read_exercise(command.folder);
    } catch (...) { // a name that no exercise may have, say: nothing half-made stays
        fs::remove_all(command.folder);
        throw;
    }
    std::printf("%s is an exercise now. Change its files, then:\n  %s exercises --exercises %s verify %s\n",
                command.folder.c_str(), launcher().c_str(),
                fs::absolute(command.folder).parent_path().c_str(), command.folder.filename().c_str());
    return done;
}

} // namespace rayscope::exercises
