#include "rx.hpp"
using namespace rx;

// Bits: 1 local light, 2 a reflected ray, 4 a refracted ray, 8 a shadow ray.
unsigned plan(const Mat& m, int k, double w, double eps, bool inside) { todo(); }
