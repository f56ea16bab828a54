#include "rx.hpp"
using namespace rx;

Spans inside(Hits h) {
    std::map<double, int> net;
    for (const Hit& hit : h) net[hit.t] += hit.enter ? 1 : -1;
    Spans spans;
    bool open = false, first = true;
    double begin = -INF;
    for (const auto& [t, count] : net) {
        if (count == 0) continue;
        if (first && count < 0) open = true;
        first = false;
        if (count > 0 && !open) begin = t;
        if (count < 0 && open) spans.push_back({begin, t});
        open = count > 0;
    }
    if (open) spans.push_back({begin, INF});
    return spans;
}
