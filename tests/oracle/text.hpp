#pragma once
// Messages from parts. (Sums of strings that start with a literal make GCC 12 warn of overlaps that don't
// exist.)

#include <sstream>
#include <string>

namespace rayscope::test {

template <typename... Parts> [[nodiscard]] std::string text(const Parts&... parts) {
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
}

} // namespace rayscope::test
