#include "rx.hpp"
using namespace rx;

// (c1, c2) of each crossing. `in`: the objects around the start.
std::vector<dvec2> speeds(const std::vector<Cross>& p, std::vector<int> in, const std::vector<double>& c,
                          const std::vector<int>& priority) {
    todo();
}
