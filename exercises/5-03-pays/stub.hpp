#include "rx.hpp"
using namespace rx;

// Whether testing the box first is strictly cheaper on average. p: the share of the rays that hit the box.
bool pays(double cBox, double cObj, double p) { todo(); }
