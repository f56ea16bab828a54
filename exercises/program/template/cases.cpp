#include "cases.hpp"

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 4; ++i) c.add("any vector", c.vector(1, 4));
    c.group("edge");
    c.add("along an axis", dvec3(0, -c.between(2, 4), 0));
    c.add("nothing", dvec3(0));
    c.group("hard");
    c.add("very short", 1e-6 * c.unit());
    c.add("very long", c.between(1, 2) * 1e9 * c.unit());
}
