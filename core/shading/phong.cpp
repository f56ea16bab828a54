#include "core/shading/phong.hpp"

namespace rayscope {

double phong_power(double x, double n) {
    double whole = std::floor(n);
    double fraction = n - whole;
    double result = 1;
    for (double square = x; whole > 0; square *= square) {
        if (square == 0) return 0; // the leading digit of n is still to come
        const double half = std::floor(whole / 2);
        if (whole != 2 * half) result *= square;
        whole = half;
    }
    double root = x;
    for (int bit = 0; bit < 24 && fraction > 0; ++bit) {
        root = std::sqrt(root);
        fraction *= 2;
        if (fraction >= 1) {
            result *= root;
            fraction -= 1;
        }
    }
    return result;
}

} // namespace rayscope
