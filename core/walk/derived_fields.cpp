#include "core/walk/derived_fields.hpp"

namespace rayscope {
namespace {

template <typename E> const E* here(const SeenEvent& seen) { return std::get_if<E>(&seen.happened()); }

/// What blocked a shadow ray: its search ended there.
Id blocker_of(const TracedRay& ray) {
    Id blocker = none;
    for (const Event& event : ray.events)
        if (const auto* accepted = std::get_if<ObjectAccepted>(&event)) blocker = accepted->object;
    return blocker;
}

bool is_shadow(const SeenEvent& seen) { return seen.traced().start().kind == RayKind::shadow; }

/// The end of a shadow ray whose light is seen as `test` says.
template <typename Test> bool shadow_end(const SeenEvent& seen, const Test& test) {
    const auto* end = here<RayFinished>(seen);
    return end != nullptr && is_shadow(seen) && test(end->colour);
}
bool blocked(const SeenEvent& seen) {
    return shadow_end(seen, [](const Colour& c) { return c == Colour{0}; });
}

Id object_here(const SeenEvent& seen) {
    if (const auto* hit = here<BoundaryChosen>(seen)) return hit->object;
    if (const auto* passed = here<BlockerPassed>(seen)) return passed->object;
    return blocked(seen) ? blocker_of(seen.traced()) : none;
}

Value object_name(const SeenEvent& seen) {
    const Id id = object_here(seen);
    return id == none ? Value() : Value(std::string_view(seen.trace.objects[std::size_t(id)].name));
}
Value material_name(const SeenEvent& seen) {
    const Id id = object_here(seen);
    return id == none ? Value() : Value(std::string_view(seen.trace.objects[std::size_t(id)].material));
}
Value hit_t(const SeenEvent& seen) {
    if (const auto* hit = here<BoundaryChosen>(seen)) return hit->boundary.t;
    if (const auto* passed = here<BlockerPassed>(seen)) return passed->t;
    return {};
}
Value cell_number(const SeenEvent& seen) {
    const auto* place = here<PlaceEntered>(seen);
    return place != nullptr && place->kind == PlaceKind::cell ? Value(double(place->place)) : Value();
}

bool is_cut(const SeenEvent& seen) {
    const auto* refused = here<NotSpawned>(seen);
    return refused != nullptr && (refused->reason == Reason::depth || refused->reason == Reason::weight ||
                                  refused->reason == Reason::ray_limit);
}
bool is_lit(const SeenEvent& seen) {
    const auto* lit = here<LightLit>(seen);
    return lit != nullptr && lit->diffuse + lit->specular != Colour{0};
}

/// Members of that name stay what they are, for who names their event.
void derive(FieldEntry& entry, ValueType type, FieldEntry::OfAll read, std::string_view help,
            Target target = {}) {
    entry.derived = read;
    entry.derived_type = type;
    entry.help = help;
    entry.target = target;
}

template <std::size_t kind> bool is_kind(const SeenEvent& seen) { return seen.happened().index() == kind; }

} // namespace

void add_derived_fields(std::map<std::string, FieldEntry, std::less<>>& table) {
    const auto condition = [&](const char* name, auto test, const char* help) {
        derive(
            table[name], ValueType::condition,
            [](const SeenEvent& seen) { return Value(decltype(test)()(seen)); }, help);
    };
    const auto value = [&](const char* name, ValueType type, FieldEntry::OfAll read, const char* help,
                           Target target = {}) { derive(table[name], type, read, help, target); };
    using S = const SeenEvent&;

    condition("tir", [](S s) { return here<TotallyReflected>(s) != nullptr; }, "total internal reflection");
    condition("reflection", [](S s) { return here<Reflected>(s) != nullptr; }, "a mirrored ray is sent");
    condition("refraction", [](S s) { return here<Refracted>(s) != nullptr; }, "a bent ray is sent");
    condition(
        "hit", [](S s) { return here<BoundaryChosen>(s) != nullptr; }, "the nearest crossing is chosen");
    condition("miss", [](S s) { return here<Missed>(s) != nullptr; }, "nothing is hit");
    condition(
        "enter", [](S s) { return here<BoundaryChosen>(s) != nullptr && here<BoundaryChosen>(s)->entering; },
        "a hit where the ray goes into an object");
    condition(
        "exit", [](S s) { return here<BoundaryChosen>(s) != nullptr && !here<BoundaryChosen>(s)->entering; },
        "a hit where the ray comes out of an object");
    condition("shadow_blocked", [](S s) { return blocked(s); }, "a light is not seen at all");
    condition(
        "shadow_free", [](S s) { return shadow_end(s, [](const Colour& c) { return c == Colour{1}; }); },
        "nothing is between a point and a light");
    condition(
        "shadow_dimmed",
        [](S s) { return shadow_end(s, [](const Colour& c) { return c != Colour{0} && c != Colour{1}; }); },
        "a light is seen through something");
    condition("lit", [](S s) { return is_lit(s); }, "a light adds something");
    condition("cut", [](S s) { return is_cut(s); }, "a ray is not followed: depth, weight or number of rays");
    condition("spawn", [](S s) { return s.event == 0; }, "a ray starts");
    condition("finish", [](S s) { return here<RayFinished>(s) != nullptr; }, "a ray ends");
    condition("eye", [](S s) { return s.traced().start().kind == RayKind::eye; }, "on the first ray");
    condition("shadow", [](S s) { return is_shadow(s); }, "on a shadow ray");
    condition("divergence", [](S s) { return s.divergence; }, "here the other run goes another way");

    value("object", ValueType::word, object_name, "what is hit, or stands in a light's way", Target::object);
    value("material", ValueType::word, material_name, "of that object");
    value("t", ValueType::number, hit_t, "where the ray ends, or passes what dims a light");
    value("cell", ValueType::number, cell_number, "number of the cell that a stage looks into");
    value("ray", ValueType::number, [](S s) { return Value(double(s.ray)); }, "number of the ray");
    value(
        "parent", ValueType::number, [](S s) { return Value(double(s.traced().parent)); },
        "number of the ray that spawned it, or -1");
    value(
        "children", ValueType::number, [](S s) { return Value(double(s.traced().children.size())); },
        "how many rays it spawns");
    value("event", ValueType::word, [](S s) { return Value(event_name(s.happened())); }, "what happens");
    for (std::size_t kind = 0; kind < event_kinds; ++kind)
        table["event"].words.emplace_back(kind, event_name(kind));

    [&]<std::size_t... kind>(std::index_sequence<kind...>) {
        (derive(
             table[std::string(event_name(kind))], ValueType::condition,
             [](S s) { return Value(is_kind<kind>(s)); }, "the event of that name"),
         ...);
    }(std::make_index_sequence<event_kinds>());
}

} // namespace rayscope
