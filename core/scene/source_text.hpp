#pragma once
// A text file in memory, and the way from a line and column to the byte that stands there.

#include "core/scene/input_error.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// The whole file. Throws InputError if it is missing, no file, unreadable, empty or larger than `most_bytes`.
[[nodiscard]] std::string read_file(const std::filesystem::path& path, std::size_t most_bytes);

/// Text whose places are asked for, mostly in ascending order: then all questions together take linear time.
class SourceText {
public:
    /// Keeps a view: the text must outlive it.
    SourceText(std::string file, std::string_view text);

    [[nodiscard]] const std::string& file() const { return file_; }
    [[nodiscard]] std::string_view text() const { return text_; }

    /// Line and column of a byte. Counts from the beginning: for errors.
    [[nodiscard]] Place place_at(std::size_t offset) const;

    /// Fails at the first byte that is no UTF-8 text.
    void reject_binary() const;

    [[noreturn]] void fail(Place place, const std::string& message) const;

    /// Where each byte of a TOML string stands, and last where the string ends: value.size() + 1 places. `opening`
    /// is the place of the first quote. Where the value is not written as it reads (escapes), every place is that.
    [[nodiscard]] std::vector<Place> places_in_string(Place opening, std::string_view value);

private:
    [[nodiscard]] std::size_t offset_of(Place place);
    void restart();
    void step();

    std::string file_;
    std::string_view text_;
    std::size_t offset_ = 0; // of the place that was asked for last
    Place place_;
};

} // namespace rayscope
