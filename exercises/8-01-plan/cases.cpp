#include "cases.hpp"

void cases(Cases& c) {
    const auto share = [&] { return c.between(0.3, 0.8); };
    const Mat matt{share(), 0, 0, 0}, shiny{share(), share(), 0, 0}, mirror{0, 0, share(), 0},
        glass{0, 0, 0.1, share()}, tinted{share(), 0, 0.1, share()};
    c.group("basic");
    c.add("matt", matt, 4, 1.0, 0.001, false);
    c.add("shiny", shiny, 4, share(), 0.001, false);
    c.add("a mirror", mirror, 4, share(), 0.001, false);
    c.add("glass", glass, 4, share(), 0.001, false);
    c.add("tinted glass", tinted, 4, share(), 0.001, false);
    c.group("edge");
    c.add("a mirror, k = 0", mirror, 0, share(), 0.001, false);
    c.add("tinted glass, k = 0", tinted, 0, share(), 0.001, false);
    c.add("leaving tinted glass", tinted, 4, share(), 0.001, true);
    c.add("leaving glass", glass, 4, share(), 0.001, true);
    c.add("leaving tinted glass, k = 0", tinted, 0, share(), 0.001, true);
    c.group("hard");
    const int power = c.whole(4, 9);
    const double eps = 1.0 / (1 << power);
    c.add("the weight is exactly eps", Mat{0, 0, 0.5, 0.25}, 2, 2 * eps, eps, false);
    c.add("the weight is exactly eps, refracted", Mat{0.1, 0, 0.125, 0.5}, 2, 2 * eps, eps, false);
    c.add("w is at least eps, the product is not", Mat{0, 0.2, 0.5, 0.4}, 2, eps, eps, false);
    c.add("tiny weights", Mat{0.2, 0, 0.9, 0.05}, 2, 1e-12, 1e-13, true);
    c.add("eps = 0", Mat{0, 0, 1e-9, 0}, 1, 1e-9, 0.0, false);
}
