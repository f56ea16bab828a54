#include "rx.hpp"
using namespace rx;

unsigned plan(const Mat& m, int k, double w, double eps, bool inside) {
    unsigned bits = 0;
    if (!inside) bits |= 1U;
    if (k > 0 && m.kr > 0 && w * m.kr >= eps) bits |= 2U;
    if (k > 0 && m.kt > 0 && w * m.kt >= eps) bits |= 4U;
    if (!inside && m.kd + m.ks > 0) bits |= 8U;
    return bits;
}
