#include "rx.hpp"
using namespace rx;

// The direction of the reflected ray. The ray of direction d hits a surface with unit normal n at p.
dvec3 mirror(const dvec3& p, const dvec3& d, const dvec3& n) { todo(); }
