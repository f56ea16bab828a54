#include "rx.hpp"
using namespace rx;

// The index of refraction of medium 2 relative to medium 1.
double index21(double c1, double c2) { todo(); }

// The critical angle from medium 1 into medium 2, in radians; empty if there is none.
std::optional<double> critical(double c1, double c2) { todo(); }
