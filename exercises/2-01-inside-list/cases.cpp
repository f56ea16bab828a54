#include "cases.hpp"

namespace {

/// Ascending times, well apart; the first is an enter or an exit, then they alternate.
Hits alternating(Cases& c, int count, bool enter) {
    Hits hits;
    double t = c.between(-6, -4);
    for (int i = 0; i < count; ++i, enter = !enter) {
        hits.push_back({t, c.unit(), enter, 0});
        t += c.between(0.5, 2);
    }
    return hits;
}

Hits shuffled(Cases& c, Hits hits) {
    const Hits sorted = hits;
    const auto ascending = [](const Hits& list) {
        return std::is_sorted(list.begin(), list.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
    };
    while (ascending(hits)) c.shuffle(hits);
    return hits;
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    c.add("one pair", alternating(c, 2, true));
    c.add("two pairs", alternating(c, 4, true));
    c.add("three pairs", alternating(c, 6, true));
    c.group("edge");
    c.add("exit first", alternating(c, 3, false));
    c.add("enter last", alternating(c, 3, true));
    c.add("exit first, enter last", alternating(c, 4, false));
    c.add("one exit", alternating(c, 1, false));
    c.add("two pairs in no order", shuffled(c, alternating(c, 4, true)));
    c.add("half-open in no order", shuffled(c, alternating(c, 5, false)));
    c.add("no hit", Hits{});
    c.group("hard");
    const double t = c.between(-2, 2);
    c.add("touches", Hits{{t, c.unit(), true, 0}, {t, c.unit(), false, 0}});
    Hits parts = alternating(c, 4, true);
    parts[2].t = parts[1].t;
    c.add("two parts that touch", parts);
    Hits three = alternating(c, 6, true);
    three[3].t = three[4].t;
    c.add("the second and third part touch", three);
    Hits both = alternating(c, 3, false);
    both.push_back({both[1].t - 0.25, c.unit(), true, 0});
    both.push_back({both[3].t, c.unit(), false, 0});
    std::stable_sort(both.begin(), both.end(), [](const Hit& a, const Hit& b) { return a.t < b.t; });
    c.add("exit first, then touches, then enters", both);
}

/// Each span of the answer as a slab across the ray.
Shown show(const Hits&, const Spans&, const Spans& answer) {
    const Ray r{{0, 0, 0}, {0, 0, -1}};
    return {scene(answer_solids(r, answer), {12, 6, 2}), r};
}
