#include "exercises/grader/value.hpp"

#include <fmt/format.h>

#include <cmath>

namespace rayscope::exercises {
namespace {

/// The shortest text that gives the number back, if that has at most `digits` digits.
std::string number_text(double number, int digits) {
    if (std::isnan(number)) return "NaN";
    if (std::isinf(number)) return number > 0 ? "INF" : "-INF";
    const std::string shortest = fmt::format("{}", number), rounded = fmt::format("{:.{}g}", number, digits);
    return shortest.size() <= rounded.size() ? shortest : rounded;
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (c == '"' || c == '\\')
            result += std::string("\\") + c;
        else if (byte < 0x20 || byte >= 0x7F)
            result += fmt::format("\\x{:02x}", byte);
        else
            result += c;
    }
    return result + '"';
}

class Writer {
public:
    Writer(int digits, std::size_t most) : digits_(digits), most_(most) {}

    void add(const Value& value, bool typed) {
        if (text_.size() > most_) return;
        if (const auto* number = std::get_if<double>(&value.content))
            text_ += number_text(*number, digits_);
        else if (const auto* integer = std::get_if<std::int64_t>(&value.content))
            text_ += fmt::format("{}", *integer);
        else if (const auto* truth = std::get_if<bool>(&value.content))
            text_ += *truth ? "true" : "false";
        else if (const auto* words = std::get_if<std::string>(&value.content))
            text_ += quoted(*words);
        else if (const auto* list = std::get_if<List>(&value.content))
            braced(*list, [](const Value& item) -> const Value& { return item; });
        else if (const auto* record = std::get_if<Record>(&value.content)) {
            if (typed) text_ += printable(record->type);
            braced(record->fields, [](const auto& field) -> const Value& { return field.value; });
        } else {
            text_ += "nothing";
        }
    }
    [[nodiscard]] std::string text() && {
        if (text_.size() > most_) text_ = text_.substr(0, most_) + "…";
        return std::move(text_);
    }

private:
    // A type's name comes from where the answer comes from.
    static std::string printable(const std::string& name) {
        std::string result;
        for (const char c : name) result += c > ' ' && c < '\x7f' ? c : '?';
        return result;
    }
    template <typename Items, typename Get> void braced(const Items& items, Get get) {
        text_ += "{";
        const char* separator = "";
        for (const auto& item : items) {
            text_ += separator;
            if (text_.size() > most_) return;
            add(get(item), false);
            separator = ", ";
        }
        text_ += "}";
    }

    int digits_;
    std::size_t most_;
    std::string text_;
};

} // namespace

std::string text_of(const Value& value, int digits, std::size_t most) {
    Writer writer(digits, most);
    writer.add(value, true);
    return std::move(writer).text();
}

} // namespace rayscope::exercises
