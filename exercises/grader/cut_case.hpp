#pragma once
// A case, cut out of a recorded trace.

#include "core/rayscope.hpp"

#include <filesystem>
#include <string>

namespace rayscope::exercises {

struct CutCase {
    std::string exercise; ///< the shipped one whose function was asked there: "3-01-mirror"
    std::string add;      ///< the line of C++ that adds the case
};

/// @param event its number: the events of all rays are counted through, in the order of the file, from 0
/// Throws InputError where there is no such event, or no exercise's function answers what it does.
[[nodiscard]] CutCase cut_case(const Trace& trace, int event);
/// The same of a file. Throws InputError where it is no trace, too.
[[nodiscard]] CutCase cut_case(const std::filesystem::path& trace, int event);

} // namespace rayscope::exercises
