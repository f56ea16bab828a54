#include "core/trace/rescale.hpp"

#include <cmath>

namespace rayscope {
namespace {

struct Rescaler {
    double scale;
    void operator()(RaySpawned& e) const { e.direction /= scale; }
    void operator()(PlaceEntered& e) const {
        if (e.kind == PlaceKind::tile || e.kind == PlaceKind::entry)
            return; // from the eye, not in lengths of d
        e.t_in *= scale;
        e.t_out *= scale;
    }
    void operator()(SearchEnded& e) const { e.t *= scale; }
    void operator()(ObjectAccepted& e) const { e.t *= scale; }
    void operator()(SpanFound& e) const {
        e.enter.t *= scale;
        e.exit.t *= scale;
    }
    void operator()(ClusterMerged& e) const {
        e.t_first *= scale;
        e.t_last *= scale;
    }
    void operator()(BoundaryChosen& e) const {
        e.boundary.t *= scale;
        e.error_bound *= scale;
    }
    void operator()(auto&) const {}
};

} // namespace

template <Scalar T> double ordinary_scale(const Vec3d& direction) {
    // Binary digits: its square is far from both ends of the number range.
    constexpr int ordinary = std::is_same_v<T, float> ? 12 : 100;
    const double size = largest_component(absolute(direction));
    if (!(size > 0) || !std::isfinite(size)) return 1;
    const int exponent = std::ilogb(size);
    return std::abs(exponent) <= ordinary ? 1 : std::ldexp(1.0, -exponent);
}

template double ordinary_scale<float>(const Vec3d&);
template double ordinary_scale<double>(const Vec3d&);
template double ordinary_scale<long double>(const Vec3d&);
template double ordinary_scale<Float128>(const Vec3d&);

void rescale(TracedRay& ray, double scale) {
    for (Event& event : ray.events) std::visit(Rescaler{scale}, event);
}

} // namespace rayscope
