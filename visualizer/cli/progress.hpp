#pragma once
// How far a long work has come, on one line of the terminal.

#include <chrono>
#include <string>

namespace rayscope::cli {

/// Draws on stderr if it is a terminal, else nothing. The line is wiped at the end.
class Progress {
public:
    /// @param what comes: "reference"
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// share: 0 … 1; called by one thread at a time.
    void show(double share);

private:
    std::string what_;
    bool terminal_;
    int percent_ = -1;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace rayscope::cli
