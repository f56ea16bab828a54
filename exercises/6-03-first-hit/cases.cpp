#include "cases.hpp"

void cases(Cases& c) {
    using Cells = std::vector<Cell>;
    using Times = std::vector<double>;
    const double a = c.between(1, 2), b = a + c.between(1, 2), d = b + c.between(1, 2),
                 e = d + c.between(1, 2);
    const auto in = [&](double from, double to) { return c.between(from + 0.1, to - 0.1); };
    c.group("basic");
    c.add("in the first cell", Cells{{0.5, a, {0, 1}}, {a, b, {2}}}, Times{in(0.5, a), INF, in(a, b)});
    c.add("in the second cell", Cells{{0.5, a, {1}}, {a, b, {0, 2}}, {b, d, {3}}},
          Times{in(a, b), INF, INF, in(b, d)});
    c.add("two in one cell", Cells{{0.5, a, {}}, {a, b, {2, 0}}, {b, d, {1}}},
          Times{in(a, b), in(b, d), in(a, b)});
    c.add("nothing is hit", Cells{{0.5, a, {0}}, {a, b, {1, 2}}}, Times{INF, INF, INF});
    c.group("edge");
    c.add("a large object, a nearer small one", Cells{{0.5, a, {0}}, {a, b, {1, 0}}, {b, d, {0}}},
          Times{in(b, d), in(a, b)});
    c.add("a large object that is hit later", Cells{{0.5, a, {0}}, {a, b, {0}}, {b, d, {0, 1}}, {d, e, {1}}},
          Times{in(b, d), in(d, e)});
    c.add("missed in many cells", Cells{{0.5, a, {1}}, {a, b, {1}}, {b, d, {1, 0}}, {d, e, {1}}},
          Times{in(b, d), INF});
    c.add("no cell", Cells{}, Times{in(a, b)});
    c.group("hard");
    c.add("exactly at t1", Cells{{0.5, a, {0}}, {a, b, {1}}}, Times{a, in(a, b)});
    c.add("exactly at t1 of the next cell", Cells{{0.5, a, {0}}, {a, b, {0, 1}}, {b, d, {2}}},
          Times{b, INF, in(b, d)});
    c.add("behind the start", Cells{{0, a, {0, 1}}, {a, b, {2}}, {b, d, {3}}},
          Times{-in(a, b), INF, in(a, b), in(b, d)});
    c.add("at the start", Cells{{0, a, {0}}, {a, b, {1}}, {b, d, {0}}}, Times{0, in(a, b)});
}

/// The objects as thin walls across the ray, each where it is hit. What is drawn has no object in front of its hit.
Shown show(const std::vector<Cell>&, const std::vector<double>& tHit, const Found& right, const Found& drawn,
           const Found& answer) {
    const auto hit = [&](int i) {
        return i >= 0 && i < static_cast<int>(tHit.size()) ? tHit[static_cast<std::size_t>(i)] : INF;
    };
    const Ray r{{0, 0, 0}, {0, 0, -1}};
    std::string text;
    for (int i = 0; i < static_cast<int>(tHit.size()); ++i) {
        const double t = hit(i), begin = t > 0 ? t : t - 0.2;
        if (t < INF && !(t > 0 && t < hit(drawn.obj)))
            text += generic("object" + std::to_string(i), "cube", across(r, begin, begin + 0.1));
    }
    const char* note =
        "The object is right, the number of tests is not. This is how the tracer's octree comes "
        "to the hit.";
    const bool same = answer.obj == right.obj;
    return {scene(text, {12, 6, 2}), r, same ? note : "", same ? "octree" : ""};
}
