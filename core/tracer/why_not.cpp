#include "core/tracer/why_not.hpp"

#include "core/world/inside_list.hpp"

namespace rayscope {

WhyNot why_not(const World<double>& world, std::uint32_t object, const Ray<double>& ray, double reach,
               double hit, bool starts_on) {
    Work<double> work;
    const LeavingSurface<double>* const nowhere = nullptr;
    const auto list = crossings(world, object, ray, nowhere, work);
    if (list.empty()) return {WhyNot::Reason::line_misses};
    double behind = -infinity<double>;
    for (const Crossing<double>& crossing : list) {
        const double start = starts_on ? 2 * error_bound(world, ray, crossing) : 0;
        if (!(crossing.t > start)) {
            behind = crossing.t;
            continue;
        }
        if (!(crossing.t < reach)) return {WhyNot::Reason::beyond_reach, crossing.t};
        if (crossing.t > hit) return {WhyNot::Reason::farther, crossing.t};
        return {WhyNot::Reason::accepted, crossing.t};
    }
    return {WhyNot::Reason::behind, behind};
}

} // namespace rayscope
