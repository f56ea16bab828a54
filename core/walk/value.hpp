#pragma once
// What a field of an event, or an expression over fields, is worth.

#include "core/trace/trace.hpp"

#include <string_view>
#include <variant>

namespace rayscope {

enum class ValueType : std::uint8_t {
    condition,
    number,
    colour, ///< as a number: its largest component, as of a weight
    vector,
    word, ///< a name, or one of a few words
};

/// Nothing where the event does not have what was asked for. A text is the trace's, and lives as long.
using Value = std::variant<std::monostate, bool, double, Vec3d, std::string_view>;

/// One event with all that surrounds it.
struct SeenEvent {
    const Trace& trace;
    int ray = 0, event = 0;
    bool divergence = false; ///< here another run goes another way

    [[nodiscard]] const TracedRay& traced() const { return trace.rays[std::size_t(ray)]; }
    [[nodiscard]] const Event& happened() const { return traced().events[std::size_t(event)]; }
};

} // namespace rayscope
