#include "cases.hpp"

void cases(Cases& c) {
    const auto dear = [&] { return c.between(20, 30); };
    c.group("basic");
    c.add("a cheap box that few rays hit", c.between(2, 4), dear(), c.between(0.1, 0.3));
    c.add("a cheap box that most rays hit", c.between(8, 9), dear(), c.between(0.8, 0.9));
    c.add("a box dearer than the object", c.between(40, 60), dear(), c.between(0.1, 0.3));
    c.add("a box that half of the rays hit", c.between(4, 6), dear(), 0.5);
    c.group("edge");
    c.add("a tie", 8.0, 16.0, 0.5);
    c.add("a tie, then a little less", 8.0 - c.between(0.1, 1), 16.0, 0.5);
    c.add("every ray hits the box", c.between(2, 4), dear(), 1.0);
    c.add("no ray hits the box", c.between(2, 4), dear(), 0.0);
    c.add("most rays miss", c.between(4, 5), dear(), c.between(0.05, 0.1));
    c.group("hard");
    c.add("a sphere, as measured", c.between(1, 2.7), 1.0, c.between(0.05, 0.2));
    c.add("a sphere that few rays reach", c.between(1, 2.7), 1.0, 0.001);
    c.add("a torus", 2.0, c.between(30, 50), c.between(0.5, 0.8));
    c.add("a mesh", 2.0, 1e4, 0.999);
    c.add("a mesh that nearly every ray hits", 2.0, 1e4, 0.9999);
}

/// A ray that pays for both.
Shown show(double, double, double) {
    return {scene(generic("ball", "sphere")),
            {{0.9, 0.85, 4}, {0, 0, -1}},
            "The case has no ray. This one hits the box, and misses the ball in it: it pays for both tests.",
            "extents"};
}
