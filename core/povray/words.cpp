#include "core/povray/words.hpp"

#include "core/files/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace rayscope::povray {

std::string number(double x) {
    if (!is_finite(x)) throw std::range_error("the scene holds numbers too large for POV-Ray");
    return fmt::format("{}", x == 0 ? 0.0 : x); // −0 would read like a mistake
}

std::string vector(const Vec3d& v) {
    return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

std::string colour(const Colour& c) { return "rgb " + (c.x == c.y && c.y == c.z ? number(c.x) : vector(c)); }

std::string matrix(const Mat4d& m) {
    std::string text = "matrix <";
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) text += (column + row > 0 ? ", " : "") + number(m[column][row]);
    return text + ">";
}

Vec3d moved_point(const Mat4d& m, const Vec3d& p) {
    return p.x * Vec3d{m[0]} + p.y * Vec3d{m[1]} + p.z * Vec3d{m[2]} + Vec3d{m[3]};
}

std::string comment(std::string_view text) {
    std::string result = "// ";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const bool plain = length > 0 && !steers_terminal(utf8_code_point(text.substr(0, length)));
        if (plain)
            result += text.substr(0, length);
        else
            result += '?';
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    // A backslash at the end would take the next line into the comment for some readers.
    if (result.ends_with('\\')) result += ' ';
    return result + '\n';
}

} // namespace rayscope::povray
