#include "rx.hpp"
using namespace rx;

// The children of the cell in which r runs for a positive length, with t >= 0, front to back.
std::vector<int> order(const Box& cell, const Ray& r) { todo(); }
