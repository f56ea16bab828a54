#pragma once
// The words of an NFF file, one by one.

#include "core/math/vec.hpp"
#include "core/scene/input_error.hpp"

#include <string>
#include <string_view>

namespace rayscope {

/// A word without blanks, and where it stands.
struct NffToken {
    std::string_view text;
    Place place;
};

/// Reads words and numbers; `#` begins a comment that ends with the line. Keeps a view of the text.
class NffTokens {
public:
    NffTokens(std::string file, std::string_view text);

    /// The word that comes next; empty at the end.
    [[nodiscard]] const NffToken& peek() const { return next_; }
    NffToken take();
    [[nodiscard]] bool at_end() const { return next_.text.empty(); }
    /// True if a number, not a keyword, comes next.
    [[nodiscard]] bool number_follows() const;

    /// Throws InputError unless a finite number of at most 1e150 in size follows. `what` it is: "the radius".
    double number(std::string_view what);
    int integer(std::string_view what, int min, int max);
    Vec3d vector(std::string_view what);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[noreturn]] void fail(const NffToken& token, const std::string& message) const;

private:
    void advance();

    std::string file_;
    std::string_view rest_;
    Place here_{1, 1}; // of rest_
    NffToken next_;
};

} // namespace rayscope
