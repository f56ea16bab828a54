#pragma once
// The events of one kind that a ray's record holds.

#include "core/trace/trace.hpp"

#include <vector>

namespace rayscope {

template <typename E> [[nodiscard]] std::vector<const E*> events_of(const TracedRay& ray) {
    std::vector<const E*> list;
    for (const Event& event : ray.events)
        if (const E* found = std::get_if<E>(&event)) list.push_back(found);
    return list;
}

template <typename E> [[nodiscard]] bool has_event(const TracedRay& ray) { return ray.find<E>() != nullptr; }

} // namespace rayscope
