#include "exercises/grader/value.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace rayscope::exercises {
namespace {

constexpr int deepest = 16; // of what an exercise returns; a deeper answer is not meant

/// Reads from the front; once it fails it stays failed.
class Decoder {
public:
    explicit Decoder(std::string_view bytes) : rest_(bytes) {}

    [[nodiscard]] std::optional<Value> value(int depth = 0) {
        if (rest_.empty() || depth > deepest) return std::nullopt;
        const char tag = rest_.front();
        rest_.remove_prefix(1);
        switch (tag) {
        case 'n': return Value{};
        case 'd': return plain<double>();
        case 'i': return plain<std::int64_t>();
        case 'b': {
            const auto byte = raw<std::uint8_t>();
            return byte ? std::optional(Value{*byte != 0}) : std::nullopt;
        }
        case 's': {
            const auto size = raw<std::uint32_t>();
            const auto text = size ? take(*size) : std::nullopt;
            return text ? std::optional(Value{std::string(*text)}) : std::nullopt;
        }
        case 'l': return list(depth);
        case 'r': return record(depth);
        default: return std::nullopt;
        }
    }
    [[nodiscard]] bool at_end() const { return rest_.empty(); }

private:
    std::optional<std::string_view> take(std::size_t count) {
        if (rest_.size() < count) return std::nullopt;
        const std::string_view part = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return part;
    }
    template <typename N> std::optional<N> raw() {
        const auto bytes = take(sizeof(N));
        if (!bytes) return std::nullopt;
        N number;
        std::memcpy(&number, bytes->data(), sizeof number);
        return number;
    }
    template <typename N> std::optional<Value> plain() {
        const auto number = raw<N>();
        return number ? std::optional(Value{*number}) : std::nullopt;
    }
    std::optional<Value> list(int depth) {
        const auto count = raw<std::uint32_t>();
        if (!count || *count > rest_.size()) return std::nullopt; // each takes a byte at least
        List items;
        for (std::uint32_t i = 0; i < *count; ++i) {
            auto item = value(depth + 1);
            if (!item) return std::nullopt;
            items.push_back(std::move(*item));
        }
        return Value{std::move(items)};
    }
    std::optional<std::string> name() {
        const auto size = raw<std::uint8_t>();
        const auto text = size ? take(*size) : std::nullopt;
        return text ? std::optional(std::string(*text)) : std::nullopt;
    }
    std::optional<Value> record(int depth) {
        Record result;
        auto type = name();
        const auto count = raw<std::uint8_t>();
        if (!type || !count) return std::nullopt;
        result.type = std::move(*type);
        for (int i = 0; i < *count; ++i) {
            auto key = name();
            auto item = key ? value(depth + 1) : std::nullopt;
            if (!item) return std::nullopt;
            result.fields.push_back({std::move(*key), std::move(*item)});
        }
        return Value{std::move(result)};
    }

    std::string_view rest_;
};

template <typename N> void add_raw(std::string& to, N number) {
    char copy[sizeof number];
    std::memcpy(copy, &number, sizeof number);
    to.append(copy, sizeof number);
}
void add_name(std::string& to, const std::string& text) {
    add_raw(to, std::uint8_t(text.size()));
    to += text;
}

void encode(const Value& value, std::string& to) {
    struct {
        std::string& to;
        void operator()(std::monostate) const { to += 'n'; }
        void operator()(double number) const { to += 'd', add_raw(to, number); }
        void operator()(std::int64_t number) const { to += 'i', add_raw(to, number); }
        void operator()(bool truth) const { to += 'b', add_raw(to, std::uint8_t(truth)); }
        void operator()(const std::string& text) const {
            to += 's', add_raw(to, std::uint32_t(text.size()));
            to += text;
        }
        void operator()(const List& list) const {
            to += 'l', add_raw(to, std::uint32_t(list.size()));
            for (const Value& item : list) encode(item, to);
        }
        void operator()(const Record& record) const {
            to += 'r', add_name(to, record.type);
            add_raw(to, std::uint8_t(record.fields.size()));
            for (const auto& [name, field] : record.fields) add_name(to, name), encode(field, to);
        }
    } const put{to};
    std::visit(put, value.content);
}

bool close(double a, double b, const Tolerance& tolerance) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) && std::isnan(b);
    if (a == b) return true;
    if (std::isinf(a) || std::isinf(b)) return false;
    return std::abs(a - b) <= tolerance.absolute + tolerance.relative * std::max(std::abs(a), std::abs(b));
}

} // namespace

std::optional<Value> decoded(std::string_view bytes) {
    Decoder decoder(bytes);
    auto value = decoder.value();
    return decoder.at_end() ? value : std::nullopt;
}

std::optional<List> decoded_sequence(std::string_view bytes) {
    List list;
    for (Decoder decoder(bytes); !decoder.at_end();) {
        auto value = decoder.value();
        if (!value) return std::nullopt;
        list.push_back(std::move(*value));
    }
    return list;
}

std::string encoded(const Value& value) {
    std::string bytes;
    encode(value, bytes);
    return bytes;
}

bool same(const Value& a, const Value& b, const Tolerance& tolerance) {
    if (a.content.index() != b.content.index()) return false;
    if (const auto* number = std::get_if<double>(&a.content))
        return close(*number, std::get<double>(b.content), tolerance);
    if (const auto* list = std::get_if<List>(&a.content))
        return std::ranges::equal(*list, std::get<List>(b.content),
                                  [&](const Value& x, const Value& y) { return same(x, y, tolerance); });
    if (const auto* record = std::get_if<Record>(&a.content))
        return std::ranges::equal(record->fields, std::get<Record>(b.content).fields,
                                  [&](const auto& x, const auto& y) {
                                      return x.name == y.name && same(x.value, y.value, tolerance);
                                  });
    if (const auto* integer = std::get_if<std::int64_t>(&a.content))
        return *integer == std::get<std::int64_t>(b.content);
    if (const auto* truth = std::get_if<bool>(&a.content)) return *truth == std::get<bool>(b.content);
    if (const auto* text = std::get_if<std::string>(&a.content))
        return *text == std::get<std::string>(b.content);
    return true;
}

bool has_nan(const Value& value) {
    if (const auto* number = std::get_if<double>(&value.content)) return std::isnan(*number);
    if (const auto* list = std::get_if<List>(&value.content)) return std::ranges::any_of(*list, has_nan);
    if (const auto* record = std::get_if<Record>(&value.content))
        return std::ranges::any_of(record->fields, [](const auto& field) { return has_nan(field.value); });
    return false;
}

} // namespace rayscope::exercises
