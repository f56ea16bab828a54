#include "rx.hpp"
using namespace rx;

// Bit i: the closed child i of the cell meets obj. Bit 0 of i: upper x, bit 1: upper y, bit 2: upper z.
unsigned children(const Box& cell, const Box& obj) { todo(); }
