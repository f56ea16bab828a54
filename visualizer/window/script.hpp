#pragma once
// A script drives the window as a person would, by its real widgets, and reports what they show: one JSON object a line.

#include <iosfwd>
#include <string>

namespace rayscope::window {

class MainWindow;

/// Carries out the lines of a file and writes a report for each to `out`. Lines that begin with '#' mean nothing.
/// @return false if a line could not be carried out; the rest is carried out all the same
/// Throws cli::UsageError if the file can't be read.
[[nodiscard]] bool run_script(MainWindow& window, const std::string& file, std::ostream& out);

/// What came of a line of a script.
struct Outcome {
    std::string line;
    bool ok = false;
    double milliseconds = 0; ///< until it was drawn
};
/// And what the window shows, as one line of JSON.
[[nodiscard]] std::string report_of(MainWindow& window, const Outcome& outcome);

} // namespace rayscope::window
