#pragma once
// Numbers as text.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::cli {

/// Writes numbers with so many significant digits. Blanks inside a vector are no-break spaces (see page.hpp), so that
/// a line breaks between terms and not within one.
class Numbers {
public:
    explicit Numbers(int digits) : digits_(digits) {}

    [[nodiscard]] std::string operator()(double number) const;
    /// "(x, y, z)"
    [[nodiscard]] std::string vector(const Vec3d& v) const;
    /// A grey is one number, other colours are "(r, g, b)".
    [[nodiscard]] std::string colour(const Colour& colour) const;
    /// "48.7°" of an angle in radians.
    [[nodiscard]] std::string degrees(double radians) const;

private:
    int digits_;
};

/// "1 ray", "2 rays", with a no-break space.
[[nodiscard]] std::string counted(int count, const char* one, const char* many);

} // namespace rayscope::cli
