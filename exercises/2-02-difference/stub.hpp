#include "rx.hpp"
using namespace rx;

// The hits of the ray with A - B, ascending.
Hits difference(const Hits& A, const Hits& B) { todo(); }
