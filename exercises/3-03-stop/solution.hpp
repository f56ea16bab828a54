#include "rx.hpp"
using namespace rx;

int rays(const std::vector<double>& kr, int k, double eps) {
    double weight = 1;
    int count = 0;
    while (count < k) {
        weight *= kr[std::size_t(count) % kr.size()];
        if (!(weight > 0 && weight >= eps)) break;
        ++count;
    }
    return count;
}
