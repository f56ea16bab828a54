#include "rx.hpp"
using namespace rx;

// The colour that a ray brings which meets the surfaces p, with at most k reflection rays.
dvec3 chain(const std::vector<Bounce>& p, int k, const dvec3& bg) { todo(); }
