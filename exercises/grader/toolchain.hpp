#pragma once
// The compiler for exercises: its parts that are the same for all are compiled once and kept.

#include "core/files/temporary_folder.hpp"
#include "exercises/grader/sandbox.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rayscope::exercises {

/// What the compiler says about a line of the file that it was given.
struct Diagnostic {
    int line = 0, column = 0;
    bool error = false;
    std::string message;
};

/// A file under the name that the compiler sees.
struct SourceFile {
    std::string name, text;
};

/// What becomes a program.
struct Unit {
    std::vector<SourceFile> files; ///< the first is compiled, it includes the others
    std::string about;             ///< the file whose diagnostics are told
    bool reference = false;        ///< linked with reference_main.cpp instead of answer_main.cpp
    bool sanitized = false;        ///< with address and undefined-behaviour sanitizers: trusted code only
};

struct Compiled {
    std::filesystem::path program; ///< empty if there is none
    std::vector<Diagnostic> diagnostics;
    std::string problem; ///< why there is no program, where no diagnostic says it
};

class Toolchain {
public:
    /// @param harness the folder with rx.hpp
    /// @param runner  the program that starts others: rayscope-exercise-runner
    /// Builds what is missing. Throws std::runtime_error where there is no compiler.
    Toolchain(std::filesystem::path harness, std::filesystem::path runner, Safety safety);

    /// Compiles under limits, in the sandbox. The program is written to `to`.
    [[nodiscard]] Compiled compile(const Unit& unit, const std::filesystem::path& to) const;
    /// The same, kept under a name that depends on the unit's text: compiled only the first time.
    [[nodiscard]] Compiled kept(const Unit& unit) const;

    [[nodiscard]] Safety safety() const { return safety_; }
    [[nodiscard]] const std::filesystem::path& runner() const { return runner_; }
    /// A folder for what can be made again.
    [[nodiscard]] const std::filesystem::path& cache() const { return cache_; }

private:
    /// In a folder for each, with sanitizers and without: the harness's sources, and what is compiled of them.
    [[nodiscard]] std::filesystem::path parts() const { return cache_ / "parts"; }
    [[nodiscard]] std::string parts_inside(bool sanitized) const;
    void build_parts(bool sanitized) const;
    [[nodiscard]] std::string run_compiler(const std::vector<std::string>& arguments,
                                           const std::filesystem::path& work, std::uint64_t most_bytes,
                                           int& code) const;

    std::filesystem::path harness_, runner_, cache_;
    Safety safety_;
};

/// Where results that can be made again are kept: RAYSCOPE_EXERCISES_CACHE, XDG_CACHE_HOME or ~/.cache.
[[nodiscard]] std::filesystem::path cache_folder();

/// A new, empty folder that nobody else can enter, removed with the object.
class PrivateFolder : public TemporaryFolder {
public:
    /// @param beside is made where it is missing
    explicit PrivateFolder(const std::filesystem::path& beside);
};

} // namespace rayscope::exercises
