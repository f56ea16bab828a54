#include "visualizer/cli/conversation.hpp"

#include "visualizer/cli/failure.hpp"
#include "visualizer/cli/line_input.hpp"
#include "visualizer/cli/script.hpp"

#include <cstdio>
#include <fstream>
#include <iostream>

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

namespace rayscope::cli {
namespace {

constexpr int patience = 1000; // milliseconds

bool run_commands(Session& session, const StepOptions& options, bool as_json) {
    if (!options.script || *options.script == "-")
        return run_stream(session, std::cin, "standard input", as_json);
    std::error_code error;
    std::ifstream file(*options.script, std::ios::binary);
    if (!file || !std::filesystem::exists(*options.script, error) ||
        std::filesystem::is_directory(*options.script, error))
        throw UsageError("--script: can't read " + in_quotes(*options.script));
    return run_stream(session, file, *options.script, as_json);
}

} // namespace

bool input_waits() {
    struct stat status{};
    if (fstat(STDIN_FILENO, &status) != 0) return false;
    if (S_ISREG(status.st_mode)) return status.st_size > 0;
    if (!S_ISFIFO(status.st_mode) && !S_ISSOCK(status.st_mode)) return false;
    pollfd waiting{STDIN_FILENO, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0 || (waiting.revents & POLLIN) == 0) return false;
    return std::cin.peek() != std::istream::traits_type::eof();
}

void converse_on_terminal(Session& session) {
    LineInput input([&](const std::string& line) { return session.completions(line); });
    std::fputs(
        "\nnext, step, in, over, out, back, continue, goto N, tree, spans, light, refraction, why NAME, "
        "break,\nfind, diff, quiz, png FILE, help, quit\n",
        stdout);
    while (!session.ended()) {
        std::fputs("\n", stdout);
        const auto line = input.read(session.prompt());
        if (!line) {
            std::fputs("\n", stdout);
            break;
        }
        std::fputs(session.answer(*line).c_str(), stdout);
    }
}

int converse(Session& session, const StepOptions& options, bool interactive) {
    if (options.quiz) {
        std::printf("\n%s\n", session.answer("quiz").c_str());
        if (interactive) {
            LineInput input([](const std::string&) { return std::vector<std::string>(); });
            while (session.quizzing()) {
                const auto line = input.read(session.prompt());
                const std::string answer = session.answer(line ? *line : "quit");
                std::printf("%s\n", answer.c_str());
            }
            return done;
        }
        const bool well = run_stream(session, std::cin, "standard input", false);
        if (session.quizzing()) std::fputs(session.answer("quit").c_str(), stdout);
        return well ? done : wrong_usage;
    }
    return run_commands(session, options, false) ? done : wrong_usage;
}

int converse_in_json(Session& session, const StepOptions& options) {
    Reply begin;
    begin.command = "start";
    if (options.quiz) begin = session.reply("quiz");
    std::printf("%s\n", reply_json(session, begin, "").c_str());
    return run_commands(session, options, true) ? done : wrong_usage;
}

} // namespace rayscope::cli
