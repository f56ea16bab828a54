#include "rx.hpp"
using namespace rx;

// The nearest object that the ray hits in these cells, front to back, and the number of tests.
Found first(const std::vector<Cell>& cells, const std::vector<double>& tHit) { todo(); }
