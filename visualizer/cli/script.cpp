#include "visualizer/cli/script.hpp"

#include "visualizer/cli/failure.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

namespace rayscope::cli {
namespace {

constexpr std::size_t longest_script = std::size_t(1) << 20U, longest_line = 8000; // bytes

bool means_nothing(const std::string& line) {
    const auto begin = line.find_first_not_of(" \t\r");
    return begin == std::string::npos || line[begin] == '#';
}

std::string failure(const std::string& name, int line, const Reply& reply) {
    std::string text = reply.text;
    while (!text.empty() && text.back() == '\n') text.pop_back();
    return harmless(name) + ":" + std::to_string(line) + ": " + text;
}

/// No more of a line than is needed to refuse it: a stream may never break it.
bool next_line(std::istream& input, std::string& line) {
    line.clear();
    for (int c = input.get(); c != std::istream::traits_type::eof(); c = input.get()) {
        if (c == '\n') return true;
        if (line.size() <= longest_line) line += char(c);
    }
    return !line.empty();
}

} // namespace

std::vector<ScriptLine> read_script(const std::string& file) {
    std::ifstream input(file, std::ios::binary);
    std::error_code error;
    if (!input || !std::filesystem::is_regular_file(file, error))
        throw UsageError("can't read commands from " + in_quotes(file) + ": " +
                         (input ? "no file" : std::strerror(errno)));
    std::vector<ScriptLine> lines;
    std::size_t size = 0;
    std::string line;
    for (int number = 1; next_line(input, line); ++number) {
        size += line.size();
        if (size > longest_script) throw UsageError(harmless(file) + ": a script has at most 1 MiB");
        if (!means_nothing(line)) lines.push_back({number, line});
    }
    return lines;
}

std::string run_lines(Session& session, const std::vector<ScriptLine>& lines, const std::string& name) {
    std::string text;
    for (const ScriptLine& line : lines) {
        if (session.ended()) break;
        text += session.prompt() + harmless(line.text) + "\n";
        const Reply reply = session.reply(line.text);
        if (!reply.ok) throw UsageError(text + failure(name, line.number, reply));
        text += reply.text + "\n";
    }
    return text;
}

bool run_stream(Session& session, std::istream& input, const std::string& name, bool as_json) {
    bool all_well = true;
    std::string line;
    for (int number = 1; !session.ended() && next_line(input, line); ++number) {
        if (means_nothing(line)) continue;
        if (!as_json) std::printf("%s%s\n", session.prompt().c_str(), harmless(line).c_str());
        const Reply reply = session.reply(line);
        if (as_json)
            std::printf("%s\n", reply_json(session, reply, line).c_str());
        else if (reply.ok)
            std::printf("%s\n", reply.text.c_str());
        std::fflush(stdout);
        if (!reply.ok && session.quizzing() && !as_json) {
            std::printf("%s\n", reply.text.c_str()); // asked again
            continue;
        }
        if (!reply.ok && !as_json) throw ScriptError(failure(name, number, reply));
        all_well = all_well && reply.ok;
    }
    return all_well;
}

std::string reply_json(const Session& session, const Reply& reply, const std::string& line) {
    nlohmann::json stops = nlohmann::json::array();
    for (const StopReason& reason : session.walk().reasons())
        stops.push_back({{"number", reason.number},
                         {"kind", reason.watches ? "watch" : "break"},
                         {"expression", reason.expression},
                         {"before", value_json(reason.before)},
                         {"now", value_json(reason.now)}});
    const nlohmann::json json = {{"line", line},
                                 {"command", reply.command},
                                 {"ok", reply.ok},
                                 {"text", reply.text},
                                 {"stops", stops},
                                 {"state", state_json(session.walk())},
                                 {"ended", session.ended()}};
    return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace rayscope::cli
