#include "rx.hpp"
using namespace rx;

// The spans in which the ray is inside the one solid that has these hits.
Spans inside(Hits h) { todo(); }
