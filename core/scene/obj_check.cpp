#include "core/scene/obj_check.hpp"

#include "core/scene/input_error.hpp"
#include "core/scene/mesh_builder.hpp"
#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <charconv>

namespace rayscope {
namespace {

constexpr std::string_view blanks = " \t";

class ObjCheck {
public:
    ObjCheck(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

    void run() {
        while (!rest_.empty()) {
            ++place_.line;
            const auto end = std::min(rest_.find_first_of("\r\n"), rest_.size());
            line_ = rest_.substr(0, end);
            if (line_.find('\0') != std::string_view::npos)
                fail({}, "expected a text, found a byte of value 0");
            check_line();
            rest_.remove_prefix(
                std::min(rest_.size(), end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1)));
        }
    }

private:
    void check_line() {
        std::string_view words = line_;
        const std::string_view keyword = take(words);
        if (keyword == "v") return check_numbers(words, 3, 7); // x y z [w], or x y z r g b [a]
        if (keyword == "vn") return check_numbers(words, 3, 3);
        if (keyword == "f") check_corners(words);
    }

    void check_numbers(std::string_view words, int least, int most) const {
        int count = 0;
        for (std::string_view word = take(words); !word.empty(); word = take(words), ++count) {
            const std::string_view number = word.starts_with('+') ? word.substr(1) : word;
            double x = 0;
            const auto [end, error] = std::from_chars(number.begin(), number.end(), x);
            if (error == std::errc::invalid_argument || end != number.end() || !is_finite(x))
                fail(word, "expected a number, found " + in_quotes(word));
        }
        if (count < least || count > most)
            fail(line_, least == most
                            ? fmt::format("expected {} numbers, found {}", least, count)
                            : fmt::format("expected {} to {} numbers, found {}", least, most, count));
    }

    // vertex, vertex/texture, vertex//normal or vertex/texture/normal
    void check_corners(std::string_view words) const {
        std::size_t count = 0;
        for (std::string_view word = take(words); !word.empty(); word = take(words), ++count) {
            int part = 0;
            const char* at = word.begin();
            for (bool more = true; more; ++part) {
                int index = 0;
                const auto [end, error] = std::from_chars(at, word.end(), index);
                const bool left_out = part == 1 && end == at && end != word.end() && *end == '/';
                if (part > 2 || (!left_out && (error != std::errc{} || index == 0)))
                    fail(word, "expected a corner: VERTEX, VERTEX/TEXTURE, VERTEX//NORMAL or "
                               "VERTEX/TEXTURE/NORMAL, integers that count from 1, or from the last one with "
                               "−1; found " +
                                   in_quotes(word));
                more = end != word.end() && *end == '/';
                if (!more && end != word.end())
                    fail(word, "expected a corner of a face, found " + in_quotes(word));
                at = end + 1;
            }
        }
        if (count < 3 || count > mesh_limits::most_corners)
            fail(line_, fmt::format("expected a face of 3 to {} corners, found {}", mesh_limits::most_corners,
                                    count));
    }

    static std::string_view take(std::string_view& words) {
        words.remove_prefix(std::min(words.find_first_not_of(blanks), words.size()));
        const std::string_view word = words.substr(0, words.find_first_of(blanks));
        words.remove_prefix(word.size());
        return word;
    }

    [[noreturn]] void fail(std::string_view word, const std::string& message) const {
        Place place = place_;
        if (word.data() != nullptr) place.column = int(word.data() - line_.data()) + 1;
        throw InputError(file_, place, message);
    }

    std::string_view rest_, line_;
    const std::string& file_;
    Place place_;
};

} // namespace

void check_obj(std::string_view text, const std::string& file) { ObjCheck(text, file).run(); }

} // namespace rayscope
