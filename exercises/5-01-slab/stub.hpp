#include "rx.hpp"
using namespace rx;

// Where the line of r is in the closed box b; nothing if it misses.
std::optional<Span> slab(const Ray& r, const Box& b) { todo(); }
