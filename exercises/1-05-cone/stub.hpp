#include "rx.hpp"
using namespace rx;

// Where the line of r is inside 4(x² + y²) <= (1 - z)², |z| <= 1: one span, or none.
Spans cone(const Ray& r) { todo(); }
