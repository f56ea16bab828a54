#include "core/scene/toml_guard.hpp"

#include "core/scene/utf8.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope {
namespace {

// Offset behind a string that begins at `offset`. Where the quotes are not closed the library stops anyway.
std::size_t skip_string(std::string_view text, std::size_t offset) {
    const char quote = text[offset];
    const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
    const bool long_form = text.substr(offset).starts_with(three);
    std::size_t i = offset + (long_form ? 3 : 1);
    for (; i < text.size(); ++i) {
        if (text[i] == '\\' && quote == '"') {
            ++i;
        } else if (long_form) {
            if (text.substr(i).starts_with(three)) {
                // Up to two more quotes belong to the value.
                while (i + 3 < text.size() && text[i + 3] == quote) ++i;
                return i + 3;
            }
        } else if (text[i] == quote || text[i] == '\n') {
            return i + 1;
        }
    }
    return text.size();
}

bool is_one_of(char c, std::string_view set) { return set.find(c) != std::string_view::npos; }

// A reader of TOML's brackets, commas and equals signs. It only has to agree with the library up to the first
// mistake, where one of the two stops.
class Guard {
public:
    explicit Guard(const SourceText& source) : source_(source), text_(source.text()) {}

    void check() {
        i_ = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
        while (i_ < text_.size()) {
            const char c = text_[i_];
            if (is_one_of(c, "\"'[{")) check_before_opening();
            if (c == '"' || c == '\'')
                i_ = skip_string(text_, i_);
            else if (c == '#')
                i_ = std::min(text_.find('\n', i_), text_.size());
            else
                check_sign(c);
            before_ = c;
        }
    }

private:
    [[noreturn]] void fail(const std::string& message) const { source_.fail(source_.place_at(i_), message); }

    // Of a word that it can't read, the library looks at all characters up to a blank, comma or closing bracket.
    void check_before_opening() const {
        if (!is_one_of(before_, " \t\r\n=,[{"))
            fail(fmt::format("unexpected {}: expected a blank, =, comma or bracket before it",
                             in_quotes(text_.substr(i_, 1))));
    }

    void check_sign(char c) {
        if (const std::size_t length = utf8_length(text_.substr(i_)); length > 1)
            fail(fmt::format(
                "unexpected {}: outside of quotes TOML allows only letters without accents, digits "
                "and ASCII signs",
                in_quotes(text_.substr(i_, length))));
        if (c == '[' || c == '{') open(c);
        if ((c == ']' || c == '}') && !open_.empty()) close();
        if (c == '=') begin_value();
        if (c == ',' || (c == '\n' && open_.empty())) in_value_ = false;
        if (c == '.') ++dots_;
        if (is_one_of(c, "=,[{\n")) dots_ = 0;
        if (dots_ > most_dots)
            fail(fmt::format("this key has more than {} dots; a scene needs 2", most_dots));
        line_begins_ = c == '\n' || (line_begins_ && is_one_of(c, " \t\r"));
        ++i_;
    }

    void open(char bracket) {
        if (bracket == '[' && line_begins_ && open_.empty()) check_header();
        open_.push_back({bracket, in_value_});
        in_value_ = bracket == '['; // in a list, every word is a value
        if (open_.size() > most_brackets)
            fail(fmt::format("brackets are nested more than {} deep; a scene needs 4", most_brackets));
    }

    void close() {
        in_value_ = open_.back().in_value;
        open_.pop_back();
    }

    void begin_value() {
        const bool in_list = !open_.empty() && open_.back().kind == '[';
        if (in_value_ || in_list) fail("unexpected '=': expected a value");
        in_value_ = true;
    }

    // From the first bracket of a table's header to what must be its name.
    void check_header() {
        std::size_t i = i_ + (text_.substr(i_).starts_with("[[") ? 2 : 1);
        while (i < text_.size() && is_one_of(text_[i], " \t")) ++i;
        const auto named = [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') ||
                   is_one_of(c, "\"'_-]");
        };
        if (i < text_.size() && !named(text_[i]))
            source_.fail(source_.place_at(i), "expected the name of a table after '['");
    }

    struct Bracket {
        char kind = '[';
        bool in_value = false; // what surrounds it
    };

    const SourceText& source_;
    std::string_view text_;
    std::size_t i_ = 0;
    char before_ = '\n'; // the character, or the string's first quote, that came before
    int dots_ = 0;
    bool line_begins_ = true, in_value_ = false;
    std::vector<Bracket> open_;
};

} // namespace

void guard_toml_parser(const SourceText& source) { Guard(source).check(); }

} // namespace rayscope
