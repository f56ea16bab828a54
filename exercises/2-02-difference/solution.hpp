#include "rx.hpp"
using namespace rx;

Hits difference(const Hits& A, const Hits& B) {
    bool inA = !A.empty() && !A.front().enter, inB = !B.empty() && !B.front().enter;
    Hits result;
    for (std::size_t a = 0, b = 0; a < A.size() || b < B.size();) {
        const double t = std::min(a < A.size() ? A[a].t : INF, b < B.size() ? B[b].t : INF);
        const bool before = inA && !inB;
        const Hit *ofA = nullptr, *ofB = nullptr;
        for (; a < A.size() && A[a].t == t; ++a) ofA = &A[a], inA = A[a].enter;
        for (; b < B.size() && B[b].t == t; ++b) ofB = &B[b], inB = B[b].enter;
        const bool after = inA && !inB;
        if (before == after) continue;
        if (ofA != nullptr)
            result.push_back({t, ofA->n, after, ofA->obj});
        else
            result.push_back({t, -ofB->n, after, ofB->obj});
    }
    return result;
}
