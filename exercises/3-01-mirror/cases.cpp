#include "cases.hpp"

namespace {

/// Falls on the surface with the cosine given.
dvec3 falling(Cases& c, const dvec3& n, double cosine, double length = 1) {
    return length * (std::sqrt(1 - cosine * cosine) * c.across(n) - cosine * n);
}
/// Not along d from the origin, where a wrong formula would look right.
dvec3 point(Cases& c) { return c.vector(1, 4) * dvec3(c.sign(), c.sign(), c.sign()); }

} // namespace

void cases(Cases& c) {
    c.group("basic");
    c.add("plane z = 1", dvec3(0, 1.5, 1), dvec3(0, 0.6, -0.8), dvec3(0, 0, 1));
    for (int i = 0; i < 4; ++i) {
        const dvec3 n = c.unit();
        c.add("a slanted surface", point(c), falling(c, n, c.between(0.2, 0.9)), n);
    }
    c.group("edge");
    const dvec3 n = c.unit();
    c.add("normal incidence", point(c), -n, n);
    c.add("|d| = 2.5", point(c), falling(c, n, c.between(0.2, 0.9), 2.5), n);
    c.add("n along d", point(c), falling(c, n, c.between(0.2, 0.9)), -n);
    c.add("n along d, |d| = 0.1", point(c), falling(c, n, c.between(0.2, 0.9), 0.1), -n);
    c.group("hard");
    for (int i = 0; i < 2; ++i) c.add("|d| = 1e6", point(c), falling(c, n, c.between(0.2, 0.9), 1e6), n);
    for (int i = 0; i < 2; ++i) c.add("grazing, d·n = -1e-9", point(c), falling(c, n, 1e-9), n);
}

/// A mirror through p; the ray comes from 3 away.
Shown show(const dvec3& p, const dvec3& d, const dvec3& n) {
    const dvec3 against = dot(d, n) < 0 ? n : -n, unit = glm::normalize(d);
    return {
        scene(generic("mirror", "plane", facing(p, against), "mirror"), p + 6.0 * against + 4.0 * unit, p),
        {p - 3.0 * unit, unit}};
}
