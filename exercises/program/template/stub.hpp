#include "rx.hpp"
using namespace rx;

// The length of v.
double size(const dvec3& v) { todo(); }
