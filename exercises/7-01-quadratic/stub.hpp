#include "rx.hpp"
using namespace rx;

// The real roots of a t² + b t + c, ascending; a double root once.
std::vector<double> roots(double a, double b, double c) { todo(); }
