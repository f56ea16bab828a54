#pragma once
// Calls of a program with an exercise's code, one process each, in the sandbox.

#include "exercises/grader/child.hpp"
#include "exercises/grader/toolchain.hpp"
#include "exercises/grader/value.hpp"

#include <string>
#include <vector>

namespace rayscope::exercises {

enum class OutcomeKind {
    answered,
    not_written, ///< it stopped at todo()
    threw,       ///< an exception left the function
    crashed,     ///< a signal ended the program
    timed_out,   ///< more than two seconds of computing, or twenty of waiting
    ended_early, ///< the program ended itself without an answer, or with an exit code
    no_value,    ///< what came back is no value
    too_much,    ///< it wrote without end
    unsteady,    ///< the same call had different answers
};

/// How one call ended.
struct Outcome {
    OutcomeKind kind = OutcomeKind::no_value;
    Value value;         ///< if answered
    int detail = 0;      ///< exit code or signal
    std::string printed; ///< the beginning of what was written to stdout and stderr
};

/// A call, as words of the program and the input that it reads.
struct Call {
    std::vector<std::string> words;
    std::string input;
};

/// A program, started again for each call. One serves one thread.
class CaseRunner {
public:
    enum class Trust {
        none,
        own_code, ///< with sanitizers, which ask more of the system than untrusted code may
    };
    CaseRunner(const Toolchain& toolchain, const std::filesystem::path& program, Trust trust = Trust::none);

    [[nodiscard]] Outcome run(const Call& call);
    /// Twice: who answers differently the second time is unsteady.
    [[nodiscard]] Outcome run_twice(const Call& call);

private:
    struct Raw {
        char how = 'f';
        int detail = 0;
        std::string printed, answer;
    };
    [[nodiscard]] Raw run_raw(const Call& call);

    Child runner_;
};

/// Of the same kind, and within the tolerance.
[[nodiscard]] bool same(const Outcome& a, const Outcome& b, const Tolerance& tolerance);

/// In words, without a full stop: "crashed (SIGSEGV: it used memory that isn't its own)".
[[nodiscard]] std::string text_of(const Outcome& outcome, int digits = 17);

} // namespace rayscope::exercises
