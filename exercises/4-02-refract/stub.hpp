#include "rx.hpp"
using namespace rx;

// The refracted direction, or nothing at total internal reflection.
std::optional<dvec3> refract(dvec3 d, dvec3 n, double c1, double c2) { todo(); }
