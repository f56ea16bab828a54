#include "visualizer/cli/value_text.hpp"

#include "visualizer/cli/page.hpp"

namespace rayscope::cli {

std::string value_text(const Value& value, const Expression& of, const Numbers& number) {
    if (const auto* condition = std::get_if<bool>(&value)) return *condition ? "true" : "false";
    if (const auto* x = std::get_if<double>(&value)) return number(*x) + (of.angle() ? "°" : "");
    if (const auto* v = std::get_if<Vec3d>(&value)) {
        static const Paint plain(false);
        Page line(plain);
        line.line(of.type() == ValueType::colour ? number.colour(*v) : number.vector(*v));
        std::string text = line.text();
        text.pop_back();
        return text;
    }
    if (const auto* text = std::get_if<std::string_view>(&value)) return harmless(*text);
    return "not known at this event";
}

} // namespace rayscope::cli
