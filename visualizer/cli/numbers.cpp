#include "visualizer/cli/numbers.hpp"

#include "visualizer/cli/page.hpp"

#include <fmt/format.h>

#include <numbers>

namespace rayscope::cli {

std::string Numbers::operator()(double number) const {
    if (std::isinf(number)) return number > 0 ? "∞" : "-∞";
    return fmt::format("{:.{}g}", number == 0 ? 0.0 : number, digits_); // −0 is written 0
}

std::string Numbers::vector(const Vec3d& v) const {
    const auto& write = *this;
    return "(" + write(v.x) + "," + glue + write(v.y) + "," + glue + write(v.z) + ")";
}

std::string Numbers::colour(const Colour& colour) const {
    const bool grey = colour.x == colour.y && colour.y == colour.z;
    return grey ? (*this)(colour.x) : vector(colour);
}

std::string Numbers::degrees(double radians) const { return (*this)(radians * 180 / std::numbers::pi) + "°"; }

std::string counted(int count, const char* one, const char* many) {
    return std::to_string(count) + glue + (count == 1 ? one : many);
}

} // namespace rayscope::cli
