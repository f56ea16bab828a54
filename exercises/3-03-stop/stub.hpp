#include "rx.hpp"
using namespace rx;

// How many reflection rays are cast between mirrors whose coefficients kr repeat.
int rays(const std::vector<double>& kr, int k, double eps) { todo(); }
