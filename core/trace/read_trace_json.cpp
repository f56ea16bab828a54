// JSON → Trace, following the lists of fields. Nothing in the JSON is trusted.

#include "core/trace/check_trace.hpp"
#include "core/trace/trace_fields.hpp"
#include "core/trace/trace_json.hpp"

#include <nlohmann/json.hpp>

#include <iterator>
#include <stdexcept>

namespace rayscope {
namespace {

using Json = nlohmann::json;

/// The way to a value, kept on the stack: its text is made only for a message.
struct Where {
    const Where* outer = nullptr;
    const char* member = nullptr; ///< or, for an element of a list:
    std::size_t index = 0;

    [[nodiscard]] std::string text() const {
        if (outer == nullptr) return "the trace";
        if (member == nullptr) return outer->text() + "[" + std::to_string(index) + "]";
        return (outer->outer == nullptr ? "" : outer->text() + ".") + member;
    }
    [[noreturn]] void fail(const std::string& message) const {
        throw std::runtime_error(text() + ": " + message);
    }
    [[noreturn]] void expected(const std::string& what, const Json& found) const {
        const std::string text = found.dump(-1, ' ', true, Json::error_handler_t::replace);
        const bool short_one = found.is_primitive() && text.size() <= 60;
        fail("expected " + what + ", found " + (short_one ? text : found.type_name()));
    }
};

class Reader {
public:
    explicit Reader(Trace& trace) : trace_(trace) {}

    template <typename S>
        requires requires { Fields<S>::list; }
    void read(S& structure, const Json& json, const Where& where,
              std::initializer_list<const char*> extra = {}) {
        if (!json.is_object()) where.expected("an object", json);
        std::apply([&](const auto&... field) { (read_field(structure, field, json, where), ...); },
                   Fields<S>::list);
        constexpr std::size_t count = std::tuple_size_v<decltype(Fields<S>::list)>;
        if (json.size() != count + extra.size()) name_unknown_member<S>(json, where, extra);
    }

    template <typename T> void read(std::vector<T>& items, const Json& json, const Where& where) {
        if (!json.is_array()) where.expected("a list", json);
        for (std::size_t i = 0; i < json.size(); ++i)
            read(items.emplace_back(), json[i], {&where, nullptr, i});
    }

    void read(Event& event, const Json& json, const Where& where) {
        if (!json.is_object()) where.expected("an object", json);
        const Where name{&where, "event"};
        const auto found = json.find("event");
        if (found == json.end()) where.fail("the member 'event' is missing");
        if (!found->is_string()) name.expected("the name of an event", *found);
        if (!read_event_named(event, found->get_ref<const std::string&>(), json, where,
                              std::make_index_sequence<std::variant_size_v<Event>>()))
            name.expected("the name of an event", *found);
    }

    void read(double& number, const Json& json, const Where& where) {
        if (json.is_number())
            number = json.get<double>();
        else if (json == "inf")
            number = infinity<double>;
        else if (json == "-inf")
            number = -infinity<double>;
        else if (json == "nan")
            number = not_a_number;
        else
            where.expected("a number, \"inf\", \"-inf\" or \"nan\"", json);
    }

    void read(bool& flag, const Json& json, const Where& where) {
        if (!json.is_boolean()) where.expected("true or false", json);
        flag = json.get<bool>();
    }

    template <std::integral I> void read(I& number, const Json& json, const Where& where) {
        const bool fits = json.is_number_unsigned()
                              ? std::in_range<I>(json.get<std::uint64_t>())
                              : json.is_number_integer() && std::in_range<I>(json.get<std::int64_t>());
        if (!fits) where.expected("a whole number within range", json);
        number = json.get<I>();
    }

    void read(std::string& text, const Json& json, const Where& where) {
        if (!json.is_string()) where.expected("a text", json);
        text = json.get<std::string>();
    }

    void read(Vec3d& v, const Json& json, const Where& where) {
        if (!json.is_array() || json.size() != 3) where.expected("a list of 3 numbers", json);
        for (int i = 0; i < 3; ++i) read(v[i], json[std::size_t(i)], {&where, nullptr, std::size_t(i)});
    }

    template <typename E>
        requires requires { Words<E>::list; }
    void read(E& value, const Json& json, const Where& where) {
        std::string words;
        for (std::size_t i = 0; i < std::size(Words<E>::list); ++i) {
            if (json == Words<E>::list[i]) {
                value = E(i);
                return;
            }
            words += (i == 0 ? "" : ", ") + std::string(Words<E>::list[i]);
        }
        where.expected("one of " + words, json);
    }

private:
    template <typename S, typename M>
    void read_field(S& structure, const Field<S, M>& field, const Json& json, const Where& where) {
        const auto found = json.find(field.name);
        if (found == json.end()) where.fail("the member '" + std::string(field.name) + "' is missing");
        const Where here{&where, field.name};
        read(structure.*field.member, *found, here);
        if constexpr (std::same_as<M, Id>) check_id(structure.*field.member, field.target, here);
    }

    void check_id(Id id, Target target, const Where& where) const {
        const std::size_t size = target_size(trace_, target);
        const bool may_be_none = allows_none(target);
        if (target == Target::nothing || (id >= 0 && std::size_t(id) < size) || (id == none && may_be_none))
            return;
        where.fail("expected an index below " + std::to_string(size) + (may_be_none ? " or -1" : "") +
                   ", found " + std::to_string(id));
    }

    template <std::size_t... I>
    bool read_event_named(Event& event, const std::string& name, const Json& json, const Where& where,
                          std::index_sequence<I...>) {
        return (read_event_if<std::variant_alternative_t<I, Event>>(event, name, json, where) || ...);
    }

    template <typename E>
    bool read_event_if(Event& event, const std::string& name, const Json& json, const Where& where) {
        if (name != Fields<E>::name) return false;
        E known;
        read(known, json, where, {"event"});
        event = known;
        return true;
    }

    template <typename S>
    [[noreturn]] static void name_unknown_member(const Json& json, const Where& where,
                                                 std::initializer_list<const char*> extra) {
        for (const auto& [key, value] : json.items()) {
            const auto is_key = [&](const char* name) { return key == name; };
            const bool listed = std::apply([&](const auto&... field) { return (is_key(field.name) || ...); },
                                           Fields<S>::list);
            if (!listed && std::none_of(extra.begin(), extra.end(), is_key))
                where.fail("unknown member '" + key.substr(0, 60) + "'");
        }
        where.fail("unknown member"); // not reached: every listed member was found, so one is not listed
    }

    Trace& trace_;
};

} // namespace

Trace trace_from_json(const Json& json) {
    const Where top;
    if (!json.is_object()) top.expected("an object", json);
    if (const auto format = json.find("format"); format == json.end() || *format != trace_format_name)
        top.fail("this is no trace: expected the member \"format\": \"" + std::string(trace_format_name) +
                 "\"");
    const auto version = json.find("version");
    if (version == json.end() || *version != trace_schema_version)
        Where{&top, "version"}.expected(std::to_string(trace_schema_version),
                                        version == json.end() ? Json() : *version);
    Trace trace;
    Reader(trace).read(trace, json, top, {"format", "version"});
    check_trace(trace);
    return trace;
}

} // namespace rayscope
