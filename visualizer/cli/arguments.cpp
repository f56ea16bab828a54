#include "visualizer/cli/arguments.hpp"

#include "visualizer/cli/failure.hpp"

#include <charconv>
#include <vector>

namespace rayscope::cli {
namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t at = text.find(separator); at != std::string_view::npos; at = text.find(separator)) {
        parts.push_back(text.substr(0, at));
        text.remove_prefix(at + 1);
    }
    parts.push_back(text);
    return parts;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

/// The whole of the text as a number, or nothing; independent of the locale.
template <typename Number> std::optional<Number> number_of(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return number;
}

[[noreturn]] void expected(const std::string& option, const std::string& what, const std::string& found) {
    throw UsageError(option + ": expected " + what + ", found " + in_quotes(found));
}

} // namespace

std::pair<int, int> parse_pixel(const std::string& text) {
    const auto parts = split(text, ',');
    const auto x = number_of<int>(parts.front()), y = number_of<int>(parts.back());
    if (parts.size() != 2 || !x || !y || *x < 0 || *y < 0)
        expected("--pixel", "X,Y: column and row from the top left, from 0 (such as 256,200)", text);
    return {*x, *y};
}

Ray<double> parse_ray(const std::string& text) {
    const auto parts = split(text, ',');
    std::vector<double> numbers;
    for (const std::string_view part : parts) {
        const auto number = number_of<double>(part);
        if (!number || !std::isfinite(*number)) break;
        numbers.push_back(*number);
    }
    if (parts.size() != 6 || numbers.size() != 6)
        expected("--ray", "six finite numbers ox,oy,oz,dx,dy,dz: origin and direction (such as 0,0,5,0,0,-1)",
                 text);
    const Ray<double> ray{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
    if (length(ray.direction) == 0) throw UsageError("--ray: the direction is 0,0,0; it must lead somewhere");
    return ray;
}

Size parse_size(const std::string& text) {
    constexpr int longest = 32768;
    constexpr std::int64_t most_pixels = 100'000'000;
    const auto parts = split(text, 'x');
    const auto width = number_of<int>(parts.front()), height = number_of<int>(parts.back());
    if (parts.size() != 2 || !width || !height || *width < 1 || *height < 1 || *width > longest ||
        *height > longest)
        expected("--size", "WIDTHxHEIGHT in pixels, 1 to 32768 each (such as 640x480)", text);
    if (std::int64_t(*width) * *height > most_pixels) expected("--size", "at most 10⁸ pixels in all", text);
    return {*width, *height};
}

int parse_count(const std::string& option, const std::string& text, int least, int most) {
    const auto number = number_of<int>(text);
    if (!number || *number < least || *number > most)
        expected(option, "a whole number from " + std::to_string(least) + " to " + std::to_string(most),
                 text);
    return *number;
}

double parse_number(const std::string& option, const std::string& text) {
    const auto number = number_of<double>(text);
    if (!number || !is_finite(*number)) expected(option, "a finite number", text);
    return *number;
}

double parse_positive(const std::string& option, const std::string& text) {
    const auto number = number_of<double>(text);
    if (!number || !is_finite(*number) || !(*number > 0)) expected(option, "a number above 0", text);
    return *number;
}

Heat parse_heat(const std::string& text) {
    std::vector<std::string_view> known;
    for (const HeatName& heat : heat_names) {
        if (text == heat.name) return Heat(&heat - heat_names.data());
        known.push_back(heat.name);
    }
    throw UsageError("--heat: expected " + one_of(known) + ", found " + in_quotes(text) +
                     did_you_mean(text, known));
}

} // namespace rayscope::cli
