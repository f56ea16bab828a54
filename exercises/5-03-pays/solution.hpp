#include "rx.hpp"
using namespace rx;

bool pays(double cBox, double cObj, double p) { return cBox + p * cObj < cObj; }
