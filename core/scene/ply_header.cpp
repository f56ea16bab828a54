#include "core/scene/ply_header.hpp"

#include "core/scene/wording.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace rayscope {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};
constexpr std::array<TypeName, 16> type_names{{{"char", PlyType::int8},
                                               {"int8", PlyType::int8},
                                               {"uchar", PlyType::uint8},
                                               {"uint8", PlyType::uint8},
                                               {"short", PlyType::int16},
                                               {"int16", PlyType::int16},
                                               {"ushort", PlyType::uint16},
                                               {"uint16", PlyType::uint16},
                                               {"int", PlyType::int32},
                                               {"int32", PlyType::int32},
                                               {"uint", PlyType::uint32},
                                               {"uint32", PlyType::uint32},
                                               {"float", PlyType::float32},
                                               {"float32", PlyType::float32},
                                               {"double", PlyType::float64},
                                               {"float64", PlyType::float64}}};

std::vector<std::string_view> words_of(std::string_view line) {
    std::vector<std::string_view> words;
    while (true) {
        const auto begin = line.find_first_not_of(" \t\r");
        if (begin == std::string_view::npos) return words;
        line.remove_prefix(begin);
        const auto end = std::min(line.find_first_of(" \t\r"), line.size());
        words.push_back(line.substr(0, end));
        line.remove_prefix(end);
    }
}

class HeaderReader {
public:
    HeaderReader(std::string_view text, const std::string& file) : text_(text), file_(file) {}

    PlyHeader read() {
        next_line();
        if (words_.size() != 1 || words_[0] != "ply") fail("expected 'ply', the first line of a PLY file");
        bool has_format = false;
        while (true) {
            next_line();
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") break;
            if (words_[0] == "format") {
                read_format();
                has_format = true;
            } else if (words_[0] == "element") {
                read_element();
            } else if (words_[0] == "property") {
                read_property();
            } else {
                fail("expected format, element, property, comment or end_header, found " +
                     in_quotes(words_[0]));
            }
        }
        if (!has_format) fail("expected a line 'format …' before end_header");
        header_.body = at_;
        header_.body_line = line_ + 1;
        check_size();
        return std::move(header_);
    }

private:
    void next_line() {
        ++line_;
        if (at_ >= text_.size()) fail("expected 'end_header', found the end of the file");
        const auto end = std::min(text_.find('\n', at_), text_.size());
        words_ = words_of(text_.substr(at_, std::min<std::size_t>(end - at_, 4096)));
        at_ = std::min(end + 1, text_.size());
    }

    void read_format() {
        const std::array<std::string_view, 3> formats{"ascii", "binary_little_endian", "binary_big_endian"};
        const auto* const found =
            words_.size() == 3 ? std::find(formats.begin(), formats.end(), words_[1]) : formats.end();
        if (found == formats.end() || words_[2] != "1.0")
            fail("expected 'format ascii 1.0', or binary_little_endian or binary_big_endian in place of "
                 "ascii");
        header_.format = PlyFormat(found - formats.begin());
    }

    void read_element() {
        PlyElement element;
        if (words_.size() == 3) {
            element.name = words_[1];
            const auto [end, error] = std::from_chars(words_[2].begin(), words_[2].end(), element.count);
            if (error == std::errc{} && end == words_[2].end()) {
                header_.elements.push_back(std::move(element));
                return;
            }
        }
        fail("expected 'element NAME COUNT', for example 'element vertex 8'");
    }

    void read_property() {
        if (header_.elements.empty()) fail("expected an element before its first property");
        PlyProperty property;
        if (words_.size() == 3) {
            property.type = type(words_[1]);
        } else if (words_.size() == 5 && words_[1] == "list") {
            property.count = type(words_[2]);
            if (*property.count >= PlyType::float32)
                fail("expected an integer type for the length of a list");
            property.type = type(words_[3]);
        } else {
            fail("expected 'property TYPE NAME' or 'property list TYPE TYPE NAME'");
        }
        property.name = words_.back();
        if (header_.elements.back().find(property.name))
            fail(fmt::format("the element has two properties {}", in_quotes(property.name)));
        header_.elements.back().properties.push_back(property);
    }

    [[nodiscard]] PlyType type(std::string_view name) const {
        const auto* const found = std::find_if(type_names.begin(), type_names.end(),
                                               [&](const TypeName& t) { return t.name == name; });
        if (found == type_names.end())
            fail("expected a type: char, uchar, short, ushort, int, uint, float or double; found " +
                 in_quotes(name));
        return found->type;
    }

    // Before memory is asked for: what is promised must have room in the file.
    void check_size() const {
        std::size_t left = text_.size() - header_.body;
        for (const PlyElement& element : header_.elements) {
            std::size_t least = 0; // bytes of one element
            for (const PlyProperty& p : element.properties)
                least += header_.format == PlyFormat::ascii ? 2 : size_of(p.count.value_or(p.type));
            if (least == 0) continue;
            if (element.count > (left + 1) / least) // the last one may end without a blank
                throw InputError(file_, {},
                                 fmt::format("expected {} elements {}, but the file has room for {} at most",
                                             element.count, in_quotes(element.name), (left + 1) / least));
            left -= std::min(left, element.count * least);
        }
    }

    [[noreturn]] void fail(const std::string& message) const { throw InputError(file_, {line_, 0}, message); }

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    int line_ = 0;
    std::vector<std::string_view> words_;
    PlyHeader header_;
};

} // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[std::size_t(type)];
}

std::optional<std::size_t> PlyElement::find(std::string_view property) const {
    for (std::size_t i = 0; i < properties.size(); ++i)
        if (properties[i].name == property) return i;
    return std::nullopt;
}

PlyHeader read_ply_header(std::string_view text, const std::string& file) {
    return HeaderReader(text, file).read();
}

} // namespace rayscope
