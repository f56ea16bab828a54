#pragma once
// The built program `rayscope`, run as a person or a script would.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace rayscope::test {

struct Outcome {
    int code = -1; ///< exit code, or 128 + signal
    std::string out, err;
};

struct Setting {
    std::filesystem::path folder = RAYSCOPE_SOURCE_DIR; ///< where it runs
    std::vector<std::string> environment{};             ///< "NAME=value", added to the test's own
    std::optional<unsigned> largest_file{};             ///< bytes that it may write into a file
};

/// Runs it with pipes instead of a terminal, and no input.
[[nodiscard]] Outcome run_program(const std::vector<std::string>& arguments, const Setting& setting = {});

/// The program on a terminal of 80 columns of its own.
class TerminalProgram {
public:
    explicit TerminalProgram(const std::vector<std::string>& arguments, const Setting& setting = {});
    ~TerminalProgram();
    TerminalProgram(const TerminalProgram&) = delete;
    TerminalProgram& operator=(const TerminalProgram&) = delete;

    void type(const std::string& keys);

    /// All that was shown since the last call, up to and with the text. Fails the test and returns what there was
    /// if the text does not come in time.
    std::string shown_until(const std::string& text);

    /// Waits for the end: exit code, or 128 + signal. Fails the test if it does not come in time.
    /// @param nudge typed at once, and again every second until the program ends
    [[nodiscard]] int code(const std::string& nudge = "");

    /// What was shown since the last shown_until; complete after code().
    [[nodiscard]] const std::string& rest() const { return buffer_; }

private:
    bool read_more(std::chrono::steady_clock::time_point deadline);
    int terminal_ = -1;
    pid_t process_ = -1;
    std::string buffer_;
    bool closed_ = false; // by the other side
};

} // namespace rayscope::test
