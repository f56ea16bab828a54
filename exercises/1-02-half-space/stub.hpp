#include "rx.hpp"
using namespace rx;

// Where the line of r is inside z <= 0: one span, or none.
Spans halfSpace(const Ray& r) { todo(); }
