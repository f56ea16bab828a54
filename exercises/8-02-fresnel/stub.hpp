#include "rx.hpp"
using namespace rx;

// The share of unpolarised light that is mirrored, exactly; 1 at total internal reflection.
double fresnel(double c1, double c2, double cosI) { todo(); }
