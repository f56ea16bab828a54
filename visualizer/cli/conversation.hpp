#pragma once
// Who types the commands of a session: a person, a script, another program.

#include "visualizer/cli/options.hpp"
#include "visualizer/cli/session.hpp"

namespace rayscope::cli {

/// On a terminal until quit or the end of input, with editing, history and completion.
void converse_on_terminal(Session& session);

/// --script, --quiz, or commands on standard input. Returns the exit code.
[[nodiscard]] int converse(Session& session, const StepOptions& options, bool interactive);

/// The same with one line of JSON for each command, and one before them that says where the session begins.
[[nodiscard]] int converse_in_json(Session& session, const StepOptions& options);

/// Whether standard input, which is no terminal, has something to say: a file that is not empty, or a pipe that brings
/// something within a second. An empty one, or one that nobody writes to, has not.
[[nodiscard]] bool input_waits();

} // namespace rayscope::cli
