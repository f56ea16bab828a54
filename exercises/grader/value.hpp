#pragma once
// A value that an exercise's function takes or returns, as the grader sees it: read from bytes that nobody trusts.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace rayscope::exercises {

struct Value;
using List = std::vector<Value>;
struct Field;
struct Record {
    std::string type;
    std::vector<Field> fields;
};
/// Nothing: an empty optional.
struct Value {
    std::variant<std::monostate, double, std::int64_t, bool, std::string, List, Record> content;
};
struct Field {
    std::string name;
    Value value;
};

/// The bytes of exactly one value (harness/wire.hpp says how they look); nothing for any others.
[[nodiscard]] std::optional<Value> decoded(std::string_view bytes);
/// Of one value after the other until the bytes end.
[[nodiscard]] std::optional<List> decoded_sequence(std::string_view bytes);
[[nodiscard]] std::string encoded(const Value& value);

/// As a student would write it in C++: "Ray{{0, 0, 5}, {0, 0, -1}}". Numbers with as many digits as they need, at most
/// `digits`; beyond `most` characters it ends in "…".
[[nodiscard]] std::string text_of(const Value& value, int digits = 17, std::size_t most = 400);

/// How far two numbers may be apart and count as the same: absolute + relative · the larger of their sizes.
struct Tolerance {
    double absolute = 1e-9, relative = 1e-9;
};
/// Of the same shape, all else equal, all numbers within the tolerance. NaN equals NaN.
[[nodiscard]] bool same(const Value& a, const Value& b, const Tolerance& tolerance);
/// True if a NaN is anywhere in it.
[[nodiscard]] bool has_nan(const Value& value);

} // namespace rayscope::exercises
