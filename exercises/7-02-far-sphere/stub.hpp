#include "rx.hpp"
using namespace rx;

// (t of the middle, half the chord in t); nothing if the line of r misses the sphere.
std::optional<dvec2> chord(const Ray& r, dvec3 c, double R) { todo(); }
