#include "rx.hpp"
using namespace rx;

double size(const dvec3& v) { return std::hypot(v.x, v.y, v.z); }
