// rayscope-exercise-runner: starts one program again and again, each time with other words and input, as the grader
// asks on stdin, and tells on stdout how each run ended. It stands in the sandbox between the grader and the code that
// nobody trusts.
//
//     rayscope-exercise-runner PROGRAM computing|trusted
//     rayscope-exercise-runner PROGRAM serve   becomes the program, which then answers call after call
//
// A request: count of words, each word, the input; an answer: one byte how, the detail, what was printed, the answer.
// Counts, lengths and the detail are 4 bytes, little-endian.

#include "exercises/runner/one_run.hpp"

#include <cstdint>
#include <cstring>
#include <optional>

#include <sys/prctl.h>
#include <unistd.h>

namespace {

using namespace rayscope::runner;

bool read_bytes(char* to, std::size_t count) {
    while (count > 0) {
        const ssize_t got = read(STDIN_FILENO, to, count);
        if (got <= 0) return false;
        to += got;
        count -= std::size_t(got);
    }
    return true;
}
std::optional<std::uint32_t> read_number() {
    std::uint32_t number = 0;
    if (!read_bytes(reinterpret_cast<char*>(&number), sizeof number)) return std::nullopt;
    return number;
}
std::optional<std::string> read_text() {
    const auto size = read_number();
    if (!size) return std::nullopt;
    std::string text(*size, '\0');
    if (!read_bytes(text.data(), text.size())) return std::nullopt;
    return text;
}

void add_number(std::string& to, std::uint32_t number) {
    to.append(reinterpret_cast<const char*>(&number), sizeof number);
}
void add_text(std::string& to, const std::string& text) {
    add_number(to, std::uint32_t(text.size()));
    to += text;
}
bool write_all(const std::string& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count = write(STDOUT_FILENO, bytes.data() + done, bytes.size() - done);
        if (count <= 0) return false;
        done += std::size_t(count);
    }
    return true;
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) return 2;
    if (std::strcmp(arguments[2], "serve") == 0) become_server(arguments[1]);
    prctl(PR_SET_DUMPABLE, 0); // nobody reads this process's memory
    Run what;
    what.program = arguments[1];
    Limits limits;
    limits.computing_only = std::strcmp(arguments[2], "trusted") != 0;
    std::chrono::steady_clock::duration waited{};
    while (const auto words = read_number()) {
        what.words.clear();
        for (std::uint32_t i = 0; i < *words; ++i) {
            auto word = read_text();
            if (!word) return 1;
            what.words.push_back(std::move(*word));
        }
        auto input = read_text();
        if (!input) return 1;
        what.input = std::move(*input);
        const auto begin = std::chrono::steady_clock::now();
        const End end = run(what, limits);
        waited += std::chrono::steady_clock::now() - begin;
        if (waited > most_waiting_in_all) limits.wall = later_waiting;
        if (end.how == 't') {
            limits.cpu = later_computing;
            limits.wall = later_waiting;
        }
        std::string reply(1, end.how);
        add_number(reply, std::uint32_t(end.detail));
        add_text(reply, end.printed);
        add_text(reply, end.answer);
        if (!write_all(reply)) return 1;
    }
    return 0;
}
