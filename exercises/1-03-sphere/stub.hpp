#include "rx.hpp"
using namespace rx;

// Where the line of r is inside the unit sphere: one span, or none.
Spans sphere(const Ray& r) { todo(); }
