#pragma once
// Predict, then reveal: the decisions of a trace as questions, asked before each is shown.

#include "core/walk/timeline.hpp"

#include <string>

namespace rayscope {

enum class Quiz : std::uint8_t {
    object, ///< which object does the ray end on?
    inside, ///< is this t inside the object?
    total,  ///< is reflection total here?
    bend,   ///< which way does the ray bend?
    light,  ///< is the light seen?
};

struct Question {
    Quiz kind = Quiz::object;
    Spot spot;                        ///< the event that answers it
    std::vector<std::string> choices; ///< two or more
    std::size_t right = 0;            ///< which of them is true
    Id object = none;                 ///< inside: index into Trace::objects
    double t = 0;                     ///< inside
};

/// In the order in which the trace answers them; the same for the same trace.
/// @param names of all objects that a ray could end on, of which some are offered
[[nodiscard]] std::vector<Question> questions_of(const Trace& trace, const Timeline& timeline,
                                                 const std::vector<std::string>& names);

} // namespace rayscope
