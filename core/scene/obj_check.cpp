#include "core/scene/obj_check.hpp"

#include "core/scene/decimal_number.hpp"
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

    [[nodiscard]] ObjNumbers run() {
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
        return std::move(numbers_);
    }

private:
    void check_line() {
        std::string_view words = line_;
        const std::string_view keyword = take(words);
        if (keyword == "v")
            numbers_.positions.push_back(numbers(words, 3, 7)); // x y z [w], or x y z r g b [a]
        if (keyword == "vn") numbers_.normals.push_back(numbers(words, 3, 3));
        if (keyword == "f") check_corners(words);
    }

    // The first three.
    [[nodiscard]] Vec3d numbers(std::string_view words, int least, int most) const {
        Vec3d first{0};
        int count = 0;
        for (std::string_view word = take(words); !word.empty(); word = take(words), ++count) {
            const auto number = decimal_number(word);
            if (!number || !is_finite(*number)) fail(word, "expected a number, found " + in_quotes(word));
            if (count < 3) first[count] = *number;
        }
        if (count < least || count > most)
            fail(line_, least == most
                            ? fmt::format("expected {} numbers, found {}", least, count)
                            : fmt::format("expected {} to {} numbers, found {}", least, most, count));
        return first;
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
    ObjNumbers numbers_;
};

} // namespace

ObjNumbers check_obj(std::string_view text, const std::string& file) { return ObjCheck(text, file).run(); }

} // namespace rayscope
