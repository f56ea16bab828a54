#include "core/scene/toml_guard.hpp"

#include "core/files/utf8.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope {
namespace {

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
                skip_string(c);
            else if (c == '#')
                i_ = std::min(text_.find('\n', i_), text_.size());
            else
                check_sign(c);
            before_ = c;
        }
    }

private:
    [[noreturn]] void fail(const std::string& message) const { source_.fail(source_.place_at(i_), message); }

    // To the offset behind the string that begins here. Where its quotes are not closed the library stops anyway.
    void skip_string(char quote) {
        const std::string_view three = quote == '"' ? "\"\"\"" : "'''";
        const bool long_form = text_.substr(i_).starts_with(three);
        for (i_ += long_form ? 3 : 1; i_ < text_.size(); ++i_) {
            const char c = text_[i_];
            if (c == '\\' && quote == '"') {
                check_escape();
                ++i_;
            } else if (long_form ? text_.substr(i_).starts_with(three) : c == quote || c == '\n') {
                i_ += long_form ? 3 : 1;
                // Up to two more quotes belong to the value.
                while (long_form && i_ < text_.size() && text_[i_] == quote) ++i_;
                return;
            }
        }
        i_ = text_.size();
    }

    void check_escape() const {
        const std::size_t next = std::min(text_.find_first_not_of(" \t\r\n", i_ + 1), text_.size());
        if (utf8_length(text_.substr(next)) > 1)
            fail("expected an escape sequence, or blanks and an ASCII character, after this backslash");
    }

    // Of a word that it can't read, the library looks at all characters up to a blank, comma or closing bracket.
    void check_before_opening() const {
        if (before_ == '.') fail("expected a name without quotes: a letter or _, then letters, digits or _");
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
        ++i_;
    }

    void open(char bracket) {
        open_.push_back({bracket, in_value_, i_});
        in_value_ = bracket == '['; // in a list, every word is a value
        if (open_.size() > most_brackets)
            fail(fmt::format("brackets are nested more than {} deep; a scene needs 4", most_brackets));
    }

    void close() {
        in_value_ = open_.back().in_value;
        open_.pop_back();
    }

    void begin_value() {
        if (!open_.empty() && open_.back().kind == '[')
            fail(fmt::format("unexpected '=' in the list that begins in line {}: is its ']' missing?",
                             source_.place_at(open_.back().offset).line));
        if (in_value_) fail("unexpected '=': expected a value");
        in_value_ = true;
    }

    struct Bracket {
        char kind = '[';
        bool in_value = false; // what surrounds it
        std::size_t offset = 0;
    };

    const SourceText& source_;
    std::string_view text_;
    std::size_t i_ = 0;
    char before_ = '\n'; // the character, or the string's first quote, that came before
    int dots_ = 0;
    bool in_value_ = false;
    std::vector<Bracket> open_;
};

} // namespace

void guard_toml_parser(const SourceText& source) { Guard(source).check(); }

} // namespace rayscope
