// Trace → JSON, following the lists of fields.

#include "core/trace/trace_fields.hpp"
#include "core/trace/trace_json.hpp"

#include <nlohmann/json.hpp>

namespace rayscope {
namespace {

using Json = nlohmann::json;

template <typename S>
concept Listed = requires { Fields<S>::list; };

Json value_of(double number) {
    if (std::isnan(number)) return "nan";
    if (std::isinf(number)) return number > 0 ? "inf" : "-inf";
    return number;
}
Json value_of(bool flag) { return flag; }
Json value_of(int number) { return number; }
Json value_of(std::size_t number) { return number; }
Json value_of(const std::string& text) { return text; }
Json value_of(const Vec3d& v) { return Json::array({value_of(v.x), value_of(v.y), value_of(v.z)}); }
template <Worded E> Json value_of(E value) { return Words<E>::list[std::size_t(value)]; }
template <Listed S> Json value_of(const S& structure);

Json value_of(const Event& event) {
    return std::visit(
        []<typename E>(const E& known) {
            Json json = value_of(known);
            json["event"] = Fields<E>::name;
            return json;
        },
        event);
}

template <typename T> Json value_of(const std::vector<T>& items) {
    Json json = Json::array();
    for (const T& item : items) json.push_back(value_of(item));
    return json;
}

template <Listed S> Json value_of(const S& structure) {
    Json json = Json::object();
    std::apply([&](const auto&... field) { ((json[field.name] = value_of(structure.*field.member)), ...); },
               Fields<S>::list);
    return json;
}

} // namespace

Json to_json(const Event& event) { return value_of(event); }
Json number_json(double number) { return value_of(number); }

Json to_json(const Trace& trace) {
    Json json = value_of(trace);
    json["format"] = trace_format_name;
    json["version"] = trace_schema_version;
    return json;
}

} // namespace rayscope
