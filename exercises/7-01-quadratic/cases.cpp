#include "cases.hpp"

namespace {

struct Coefficients {
    double a, b, c;
};
/// With these roots.
Coefficients with(double a, double t0, double t1) { return {a, -a * (t0 + t1), a * t0 * t1}; }

} // namespace

void cases(Cases& c) {
    const auto add = [&](const char* about, const Coefficients& k) { c.add(about, k.a, k.b, k.c); };
    c.group("basic");
    add("two positive roots", with(c.between(1, 2), c.between(1, 2), c.between(3, 4)));
    add("two negative roots", with(c.between(1, 2), -c.between(3, 4), -c.between(1, 2)));
    add("one of each sign", with(c.between(1, 2), -c.between(1, 2), c.between(3, 4)));
    c.add("none", c.between(1, 2), c.between(0.1, 0.5), c.between(1, 2));
    c.group("edge");
    c.add("a = 0", 0.0, c.between(1, 2), c.between(1, 2));
    c.add("a = 0 and b = 0", 0.0, 0.0, c.between(1, 2));
    c.add("all 0", 0.0, 0.0, 0.0);
    add("a < 0", with(-c.between(1, 2), c.between(1, 2), c.between(3, 4)));
    c.add("b = 0", c.between(1, 2), 0.0, -c.between(1, 2));
    c.add("c = 0, b < 0", c.between(1, 2), -c.between(1, 2), 0.0);
    c.add("c = 0, b > 0", c.between(1, 2), c.between(1, 2), 0.0);
    const double root = c.whole(-8, 8);
    c.add("a double root", 2.0, -4 * root, 2 * root * root);
    c.group("hard");
    c.add("b = 1e9", 1.0, 1e9, c.between(1, 2));
    c.add("b = -1e9", 1.0, -1e9, c.between(1, 2));
    c.add("a = 1e-9, b = 1e9", 1e-9, 1e9, -c.between(1, 2));
    c.add("a = 1e-9, b = -1e9", 1e-9, -1e9, c.between(1, 2));
}

/// A ball, or without t² a plane, that the ray hits where the roots are: the equation is that of the ray.
Shown show(double a, double b, double c, const std::vector<double>& right,
           const std::vector<double>& answer) {
    constexpr const char* note =
        "The case has no ray. This one hits where the roots are: its equation is that of the case.";
    if (a == 0) {
        const Ray r{{0, 0, c}, {0, 0, b == 0 ? 1 : b}};
        std::string planes;
        for (std::size_t i = 0; i < answer.size(); ++i)
            planes += generic("plane" + std::to_string(i), "plane", facing(r.o + answer[i] * r.d, {0, 0, 1}),
                              "clear");
        return {scene(planes), r, note};
    }
    const double length = std::sqrt(std::abs(a));
    const Ray r{{b / (2 * a) * length, right.empty() ? 2 : 0, 0}, {length, 0, 0}};
    std::string ball =
        generic("ball", "sphere", glm::translate(dmat4(1), dvec3(0, right.empty() ? 0 : 50, 0)));
    if (answer.size() == 2 && answer[0] != answer[1])
        ball = generic("ball", "sphere",
                       glm::scale(glm::translate(dmat4(1), r.o + (answer[0] + answer[1]) / 2 * r.d),
                                  dvec3(std::abs(answer[1] - answer[0]) / 2 * length)));
    return {scene(ball), r, note};
}
