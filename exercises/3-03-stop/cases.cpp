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

/// A ray that goes round between as many mirrors as there are coefficients, for ever. An answer is drawn as a limit on
/// the number of rays.
Shown show(std::vector<double> kr, int k, double eps, int right, int answer) {
    constexpr int most = 256; // that a scene may ask for
    if (kr.size() == 1) kr.push_back(kr.front());
    std::string mirrors;
    dvec3 first(0), last(0);
    for (std::size_t i = 0; i < kr.size(); ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(kr.size());
        last = i == 1 && kr.size() == 2 ? -first : dvec3(std::cos(angle), std::sin(angle), 0);
        if (i == 0) first = last;
        const std::string name = "mirror" + std::to_string(i);
        mirrors += "\n[materials." + name + "]\nambient = 0.1\ndiffuse = 0\nreflection = " + digits(kr[i]) +
                   "\n" + generic(name, "plane", facing(last, -last), name);
    }
    const bool drawn = answer != right && answer >= 0 && answer <= most;
    return {"[limits]\nmax_depth = " + std::to_string(drawn ? answer : std::min(k, most)) +
                "\nmin_weight = " + digits(drawn ? 0 : eps) + "\n\n" + scene(mirrors, {0, 0, 0.9}),
            {(first + last) / 2.0, first - last}};
}
