#include "core/cases/exact_cases.hpp"

namespace rayscope {

LineCase at_epsilon(LineCase exact, double epsilon) {
    const double scale = epsilon / exact.epsilon;
    for (ExactBound& bound : exact.bounds) {
        bound.tolerance *= scale;
        bound.tight_tolerance *= scale;
        // The files state normals in doubles: nothing finer can be asked of them.
        if (bound.normal_tolerance)
            bound.normal_tolerance = maximum(*bound.normal_tolerance * scale, 2 * rayscope::epsilon<double>);
    }
    exact.tolerance_sum *= scale;
    exact.epsilon = epsilon;
    return exact;
}

} // namespace rayscope
