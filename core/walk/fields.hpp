#pragma once
// The names that expressions know: every member of every event as the trace's JSON names it, and a few words of what
// people look for.

#include "core/trace/trace_fields.hpp"
#include "core/walk/value.hpp"

#include <array>
#include <map>
#include <string>

namespace rayscope {

inline constexpr std::size_t event_kinds = std::variant_size_v<Event>;

/// "ray_spawned", …: the name of Event::index().
[[nodiscard]] std::string_view event_name(std::size_t kind);
[[nodiscard]] inline std::string_view event_name(const Event& event) { return event_name(event.index()); }

/// A name that stands for a value.
struct FieldEntry {
    using OfEvent = Value (*)(const Trace&, const Event&);
    using OfAll = Value (*)(const SeenEvent&);

    ValueType type = ValueType::number;
    bool angle = false;                          ///< its value is in degrees
    std::array<OfEvent, event_kinds> of_event{}; ///< by Event::index(); nullptr: the event has none
    OfAll derived = nullptr;                     ///< what the bare name means, instead of members
    ValueType derived_type = ValueType::number;
    Target target = Target::nothing; ///< words that are names: of what
    /// Words that are no names: all that there are, each with the kind of event that says it.
    std::vector<std::pair<std::size_t, std::string_view>> words;
    std::string_view help; ///< of derived ones

    [[nodiscard]] ValueType type_of(std::size_t of_kind) const {
        return derived != nullptr && of_kind == event_kinds ? derived_type : type;
    }
};

/// By name: members of events, such as "t", "enter.t", "theta_from", and derived ones, such as "object", "tir".
[[nodiscard]] const std::map<std::string, FieldEntry, std::less<>>& fields();

/// The value at an event. A member that rays themselves have is the ray's, everywhere on it; of the event's own alone
/// where `of_kind` names its kind.
[[nodiscard]] Value value_of(const FieldEntry& field, const SeenEvent& seen,
                             std::size_t of_kind = event_kinds);

} // namespace rayscope
