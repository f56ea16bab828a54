#include "rx.hpp"
using namespace rx;

// The ray r, as seen by the generic with matrix M. t means the same in both spaces.
Ray toObject(const Ray& r, const dmat4& M) { todo(); }
