#include "cases.hpp"

void cases(Cases& c) {
    using Coefficients = std::vector<double>;
    const auto some = [&] { return c.between(0.4, 0.7); };
    c.group("basic");
    for (int i = 0; i < 2; ++i) c.add("eps ends it", Coefficients{some(), some()}, 30, 0.01);
    for (int i = 0; i < 2; ++i) c.add("k ends it", Coefficients{c.between(0.8, 0.95)}, c.whole(2, 4), 0.001);
    c.group("edge");
    c.add("kr = 1", Coefficients{1}, c.whole(5, 50), 0.001);
    c.add("kr = 0", Coefficients{some(), 0}, 8, 0.0);
    c.add("the weight is exactly eps", Coefficients{0.5, 0.25}, 8, 0.125);
    c.add("the weight is exactly eps, later", Coefficients{0.5}, 20, 1.0 / (1 << c.whole(4, 9)));
    c.add("one bright, one dim", Coefficients{0.9, 0.005}, 8, 0.01);
    c.add("k = 0", Coefficients{some()}, 0, 0.01);
    c.group("hard");
    c.add("unequal mirrors", Coefficients{0.9, 0.2}, c.whole(20, 30), 0.001);
    c.add("nearly perfect, k ends it", Coefficients{1, 1, 0.999}, c.whole(300, 600), 0.5);
    c.add("nearly perfect, eps ends it", Coefficients{1, 1, 0.999}, 5000, 0.5);
    c.add("eps = 2^-20", Coefficients{0.5, some()}, 100, 1.0 / (1 << 20));
}
