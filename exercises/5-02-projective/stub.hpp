#include "rx.hpp"
using namespace rx;

// The rectangle of pixels that the cube [-1, 1]³, moved by M, covers; {1, 1, 0, 0} if none.
Rect extent(const dmat4& M, const Cam& c) { todo(); }
