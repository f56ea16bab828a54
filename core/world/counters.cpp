#include "core/world/counters.hpp"

namespace rayscope {

Counters& Counters::operator+=(const Counters& other) {
    for (std::size_t i = 0; i < rays.size(); ++i) rays[i] += other.rays[i];
    for (std::size_t i = 0; i < tests.size(); ++i) tests[i] += other.tests[i];
    objects += other.objects;
    compounds += other.compounds;
    nodes += other.nodes;
    cells += other.cells;
    boxes += other.boxes;
    boxes_missed += other.boxes_missed;
    cut_by_depth += other.cut_by_depth;
    cut_by_weight += other.cut_by_weight;
    cut_by_ray_limit += other.cut_by_ray_limit;
    total_reflections += other.total_reflections;
    return *this;
}

} // namespace rayscope
