#pragma once
// Names in expressions that no event has as a member: what happened, in a word.

#include "core/walk/fields.hpp"

namespace rayscope {

/// Each event's own name too, as a condition.
void add_derived_fields(std::map<std::string, FieldEntry, std::less<>>& table);

} // namespace rayscope
