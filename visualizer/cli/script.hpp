#pragma once
// Commands from a file or a pipe.

#include "visualizer/cli/session.hpp"

#include <functional>
#include <istream>

namespace rayscope::cli {

/// A line of a script that means something, and its number.
struct ScriptLine {
    int number;
    std::string text;
};

/// Without empty lines and those that begin with '#'. Throws UsageError if the file can't be read or is no text.
[[nodiscard]] std::vector<ScriptLine> read_script(const std::string& file);

/// All that the lines are answered, each after its prompt. Throws UsageError "FILE:LINE: …" at the first that fails.
[[nodiscard]] std::string run_lines(Session& session, const std::vector<ScriptLine>& lines,
                                    const std::string& name);

/// Reads, answers and prints line by line, as JSON (one object a line) where asked for. Ends with the input or by
/// quit. Throws UsageError "NAME:LINE: …" at the first line that fails; as JSON that is said in its object, and the rest
/// is carried out.
/// @return false if a line failed
[[nodiscard]] bool run_stream(Session& session, std::istream& input, const std::string& name, bool as_json);

/// One object without line breaks: command, ok, text, state (see state_json), stops.
[[nodiscard]] std::string reply_json(const Session& session, const Reply& reply, const std::string& line);

} // namespace rayscope::cli
