#include "rx.hpp"
using namespace rx;

// Where the line of r is inside x² + y² <= 1, |z| <= 1: one span, or none.
Spans cylinder(const Ray& r) { todo(); }
