#include "rx.hpp"
using namespace rx;

// The unit normal in the world; n is the normal in the object space of a shape with matrix M.
dvec3 worldNormal(const dvec3& n, const dmat4& M) { todo(); }
