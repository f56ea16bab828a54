#include "rx.hpp"
using namespace rx;

// What happens at the wall of an object of speed c in air; nOut points outwards.
Wall wall(dvec3 d, dvec3 nOut, double c) { todo(); }
