#pragma once
// The benchmarks of `rayscope bench`. A new one: its function here, its line in the table of main.cpp.

#include <string>
#include <vector>

namespace rayscope::bench {

/// What the command line asks of a benchmark: arguments for Google Benchmark, the program's name first.
using Arguments = std::vector<std::string>;

/// Each prints its table and returns the exit code.
[[nodiscard]] int accuracy_cost(const Arguments& arguments);
[[nodiscard]] int effects_cost(const Arguments& arguments);
/// Reads the words of its command line itself.
[[nodiscard]] int stages_cost(const Arguments& words);

} // namespace rayscope::bench
