#pragma once
// A measurement as a table, as CSV, and as JSON (format rayscope-accuracy, version 1).

#include "core/accuracy/measure.hpp"

namespace rayscope {

struct AccuracyReport {
    std::string scene;
    Reference reference;
    std::vector<Measured> list;
    std::vector<std::string> sentences;
};

[[nodiscard]] std::string accuracy_table(const AccuracyReport& report);
[[nodiscard]] std::string accuracy_csv(const AccuracyReport& report);
[[nodiscard]] std::string accuracy_json(const AccuracyReport& report);

} // namespace rayscope
