#include "core/scene/source_text.hpp"

#include "core/files/utf8.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <utility>

namespace rayscope {
namespace {

// Bytes from the first quote to the value: TOML drops a line end right after three quotes.
std::size_t opening_length(std::string_view text) {
    if (!text.starts_with("\"\"\"") && !text.starts_with("'''")) return 1;
    const std::string_view rest = text.substr(3);
    return rest.starts_with("\r\n") ? 5 : rest.starts_with("\n") ? 4 : 3;
}

} // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most_bytes) {
    const auto fail = [&](const std::string& message) { throw InputError(path.string(), {}, message); };
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::none)
        fail("the file can't be looked at: " + error.message());
    if (!std::filesystem::exists(status)) fail("there is no such file");
    if (std::filesystem::is_directory(status)) fail("expected a file, this is a directory");
    if (!std::filesystem::is_regular_file(status) && !std::filesystem::is_fifo(status))
        fail("expected a file, this is a device");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) fail("the file can't be opened for reading");

    std::string content;
    const auto size = std::filesystem::file_size(path, error); // a pipe has none
    if (!error && size <= most_bytes) content.reserve(size);
    std::array<char, 1 << 16> block;
    while (stream.read(block.data(), block.size()), stream.gcount() > 0) {
        content.append(block.data(), std::size_t(stream.gcount()));
        if (content.size() > most_bytes)
            fail(fmt::format("the file is larger than {} MiB", most_bytes >> 20U));
    }
    if (stream.bad()) fail("the file can't be read");
    if (content.empty()) fail("the file is empty, expected a scene");
    return content;
}

SourceText::SourceText(std::string file, std::string_view text) : file_(std::move(file)), text_(text) {
    restart();
}

void SourceText::fail(Place place, const std::string& message) const {
    throw InputError(file_, place, message);
}

Place SourceText::place_at(std::size_t offset) const {
    const std::size_t begin = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    Place place{1, 1};
    for (const char c : text_.substr(begin, offset - std::min(begin, offset))) {
        if (c == '\n')
            place = {place.line + 1, 1};
        else if (!continues_character(c))
            ++place.column;
    }
    return place;
}

void SourceText::reject_binary() const {
    for (std::size_t i = 0; i < text_.size();) {
        const std::size_t length = utf8_length(text_.substr(i));
        if (length == 0 || text_[i] == '\0')
            fail(place_at(i), "expected text in UTF-8, found another byte: is this a scene file?");
        i += length;
    }
}

void SourceText::restart() {
    offset_ = text_.starts_with(byte_order_mark) ? byte_order_mark.size() : 0;
    place_ = {1, 1};
}

void SourceText::step() {
    const bool line_ends = text_[offset_] == '\n';
    ++offset_;
    while (offset_ < text_.size() && continues_character(text_[offset_])) ++offset_;
    place_ = line_ends ? Place{place_.line + 1, 1} : Place{place_.line, place_.column + 1};
}

std::size_t SourceText::offset_of(Place place) {
    const auto order = [](Place p) { return std::pair(p.line, p.column); };
    if (order(place) < order(place_)) restart();
    while (offset_ < text_.size() && order(place_) < order(place)) step();
    return offset_;
}

std::vector<Place> SourceText::places_in_string(Place opening, std::string_view value) {
    const std::string_view written = text_.substr(offset_of(opening));
    std::size_t begin = opening_length(written);
    std::vector<Place> places;
    places.reserve(value.size() + 1);
    const std::size_t end_of_opening = offset_ + begin;
    while (offset_ < std::min(end_of_opening, text_.size())) step();
    for (std::size_t i = 0; i <= value.size(); ++i) {
        if (i < value.size() && (offset_ >= text_.size() || text_[offset_] != value[i]))
            return std::vector<Place>(value.size() + 1, opening);
        places.push_back(place_);
        if (i == value.size()) break;
        const std::size_t character = offset_;
        step();
        for (std::size_t k = character + 1; k < offset_ && i + 1 < value.size(); ++k, ++i)
            places.push_back(places.back());
    }
    return places;
}

} // namespace rayscope
