#include "core/walk/fields.hpp"

#include "core/walk/derived_fields.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope {
namespace {

using Table = std::map<std::string, FieldEntry, std::less<>>;

constexpr std::string_view angles[] = {"theta", "theta_from", "theta_to", "critical"};
constexpr std::string_view colours[] = {
    "weight",  "background", "scene",        "material", "intensity", "visibility",  "diffuse_coefficient",
    "diffuse", "specular",   "transmission", "local",    "colour",    "coefficient", "specular_coefficient"};

bool is_in(const auto& list, std::string_view name) {
    return std::ranges::find(list, name) != std::end(list);
}

std::string_view name_in(const Trace& trace, Target target, Id id) {
    if (id == none) return "none";
    const auto i = std::size_t(id);
    switch (target) {
    case Target::object:
    case Target::object_or_none: return trace.objects[i].name;
    case Target::light:
    case Target::light_or_none: return trace.lights[i].name;
    case Target::medium_or_none: return trace.media[i].name;
    case Target::generic_or_none: return trace.generics[i];
    case Target::nothing: break;
    }
    return "";
}

template <typename M> constexpr ValueType type_of(std::string_view name, Target target) {
    if constexpr (Worded<M>) return ValueType::word;
    if constexpr (std::is_same_v<M, bool>) return ValueType::condition;
    if constexpr (std::is_same_v<M, Vec3d>)
        return is_in(colours, name) ? ValueType::colour : ValueType::vector;
    return target == Target::nothing ? ValueType::number : ValueType::word;
}

template <typename M> Value read(const Trace& trace, std::string_view name, Target target, const M& member) {
    if constexpr (Worded<M>)
        return Words<M>::list[std::size_t(member)];
    else if constexpr (std::is_same_v<M, bool> || std::is_same_v<M, Vec3d>)
        return member;
    else if constexpr (std::is_same_v<M, Id>)
        return target == Target::nothing ? Value(double(member)) : Value(name_in(trace, target, member));
    else
        return is_in(angles, name) ? member * 180 / std::numbers::pi : member;
}

template <typename S, std::size_t i> constexpr auto field_of = std::get<i>(Fields<S>::list);
template <typename S> constexpr std::size_t field_count = std::tuple_size_v<decltype(Fields<S>::list)>;
template <typename S, std::size_t i>
using MemberOf = std::remove_cvref_t<decltype(std::declval<S>().*field_of<S, i>.member)>;

void enter(Table& table, const std::string& name, std::size_t kind, FieldEntry::OfEvent reader,
           ValueType type, Target target, std::span<const std::string_view> words) {
    FieldEntry& entry = table[name];
    const bool first = std::ranges::all_of(entry.of_event, [](auto known) { return known == nullptr; });
    entry.of_event[kind] = reader;
    // A share may be one number in one event and a colour in another.
    if (first || type == ValueType::colour) entry.type = type;
    if (target != Target::nothing) entry.target = target;
    entry.angle = is_in(angles, name);
    for (const std::string_view word : words) entry.words.emplace_back(kind, word);
}

template <typename M> std::span<const std::string_view> words_of() {
    if constexpr (Worded<M>)
        return Words<M>::list;
    else
        return {};
}

// A member that is a Boundary gives its own four: of the boundary that was chosen under their plain names.
template <std::size_t kind, typename E, std::size_t i, std::size_t j> void enter_part(Table& table) {
    constexpr auto outer = field_of<E, i>;
    constexpr auto inner = field_of<Boundary, j>;
    using M = MemberOf<Boundary, j>;
    const std::string prefix =
        std::string_view(outer.name) == "boundary" ? "" : std::string(outer.name) + ".";
    enter(
        table, prefix + inner.name, kind,
        [](const Trace& trace, const Event& event) {
            constexpr auto whole = field_of<E, i>;
            constexpr auto part = field_of<Boundary, j>;
            return read(trace, part.name, part.target, std::get<E>(event).*whole.member.*part.member);
        },
        type_of<M>(inner.name, inner.target), inner.target, words_of<M>());
}

template <std::size_t kind, typename E, std::size_t i> void enter_field(Table& table) {
    constexpr auto field = field_of<E, i>;
    using M = MemberOf<E, i>;
    if constexpr (std::is_same_v<M, Boundary>) {
        [&]<std::size_t... j>(std::index_sequence<j...>) {
            (enter_part<kind, E, i, j>(table), ...);
        }(std::make_index_sequence<field_count<Boundary>>());
    } else {
        enter(
            table, field.name, kind,
            [](const Trace& trace, const Event& event) {
                constexpr auto known = field_of<E, i>;
                return read(trace, known.name, known.target, std::get<E>(event).*known.member);
            },
            type_of<M>(field.name, field.target), field.target, words_of<M>());
    }
}

template <std::size_t kind> void enter_event(Table& table) {
    using E = std::variant_alternative_t<kind, Event>;
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        (enter_field<kind, E, i>(table), ...);
    }(std::make_index_sequence<field_count<E>>());
}

Table all_fields() {
    Table table;
    [&]<std::size_t... kind>(std::index_sequence<kind...>) {
        (enter_event<kind>(table), ...);
    }(std::make_index_sequence<event_kinds>());
    add_derived_fields(table);
    return table;
}

} // namespace

std::string_view event_name(std::size_t kind) {
    static const auto names = []<std::size_t... i>(std::index_sequence<i...>) {
        return std::array<std::string_view, event_kinds>{
            Fields<std::variant_alternative_t<i, Event>>::name...};
    }(std::make_index_sequence<event_kinds>());
    return names[kind];
}

const Table& fields() {
    static const Table table = all_fields();
    return table;
}

Value value_of(const FieldEntry& field, const SeenEvent& seen, std::size_t of_kind) {
    const Event& event = seen.happened();
    if (of_kind < event_kinds) {
        constexpr std::size_t spawned = 0;
        const Event& asked = of_kind == spawned ? seen.traced().events.front() : event;
        return asked.index() == of_kind ? field.of_event[of_kind](seen.trace, asked) : Value();
    }
    if (field.derived != nullptr) return field.derived(seen);
    const auto reader = field.of_event[event.index()];
    const Event& start = seen.traced().events.front();
    if (const auto of_ray = field.of_event[start.index()]) {
        const Value value = of_ray(seen.trace, start);
        // Only a shadow ray asks for a light; others have hits that are lit.
        const auto* name = std::get_if<std::string_view>(&value);
        if (name == nullptr || *name != "none" || reader == nullptr) return value;
    }
    return reader != nullptr ? reader(seen.trace, event) : Value();
}

} // namespace rayscope
