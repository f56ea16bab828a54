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

/// A ball of the material, met from outside or left from inside. An answer is drawn by coefficients and limits that give
/// its rays, where there are such; of a reflected and a refracted one too many the first is enough.
Shown show(const Mat& m, int k, double w, double eps, bool inside, unsigned right, unsigned answer) {
    constexpr double a_little = 0.1;
    const unsigned added = answer & ~right, missing = right & ~answer;
    Mat drawn = m;
    if ((added & 2U) != 0 && m.kr == 0) drawn.kr = a_little;
    if ((added & 6U) == 4U && m.kt == 0) drawn.kt = a_little;
    if ((missing & 2U) != 0) drawn.kr = 0;
    if ((missing & 4U) != 0) drawn.kt = 0;
    const bool more = (added & 6U) != 0;
    const std::string light = (missing & 1U) != 0 ? "ambient = 0\ndiffuse = 0\n"
                                                  : "ambient = 0.1\ndiffuse = " + digits(m.kd) +
                                                        "\nspecular = " + digits(m.ks) + "\n";
    return {std::string("[scene]\nshadows = ") + ((missing & 8U) != 0 ? "false" : "true") +
                "\n\n[limits]\nmax_depth = " + std::to_string(more ? std::max(k, 1) : k) +
                "\nmin_weight = " + digits(more ? 0 : eps / w) + "\n\n[materials.asked]\n" + light +
                "reflection = " + digits(drawn.kr) + "\ntransmission = " + digits(drawn.kt) +
                "\nspeed = 0.7\n\n" + scene(generic("ball", "sphere", dmat4(1), "asked")),
            inside ? Ray{{0, 0.2, 0}, {0.1, 0.2, 1}} : Ray{{0.3, 0.4, 4}, {0, 0, -1}},
            "The case has no ray. This one meets a ball of its material."};
}
