#include "rx.hpp"
using namespace rx;

// Where the ray of direction d starts: p, shifted along n out of its error.
dvec3 spawn(dvec3 p, dvec3 err, dvec3 n, dvec3 d) { todo(); }
