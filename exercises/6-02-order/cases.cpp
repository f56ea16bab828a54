#include "cases.hpp"

namespace {

const Box cell{{-2, -2, -2}, {2, 2, 2}};

/// Crosses the three middle planes one after the other, well apart, in the order that `first` begins.
Ray passing(Cases& c, const dvec3& signs, double start) {
    std::vector<int> axes{0, 1, 2};
    c.shuffle(axes);
    Ray ray;
    double at = -1;
    for (const int axis : axes) {
        ray.d[axis] = signs[axis] * c.between(0.5, 0.9);
        ray.o[axis] = -at * ray.d[axis];
        at += c.between(0.5, 0.8);
    }
    ray.o += start * ray.d;
    return ray;
}
dvec3 mixed(Cases& c) { return c.whole(0, 1) == 0 ? dvec3(-1, 1, -1) : dvec3(1, -1, -1); }

/// Small whole numbers, so that every product is exact.
dvec3 whole(Cases& c) {
    return {c.sign() * c.whole(1, 3), c.sign() * c.whole(1, 3), c.sign() * c.whole(1, 3)};
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    for (int i = 0; i < 3; ++i) c.add("d > 0, four children", cell, passing(c, dvec3(1), -8));
    c.add("d > 0, one child", cell, Ray{{-8, -1, c.between(0.5, 1.5)}, {1, 0.01, 0.01}});
    c.add("misses", cell, Ray{{-8, 3, 3}, {1, 0.01, c.between(0.01, 0.02)}});
    c.group("edge");
    c.add("d < 0", cell, passing(c, dvec3(-1), -8));
    for (int i = 0; i < 2; ++i) c.add("mixed signs", cell, passing(c, mixed(c), -8));
    c.add("starts inside", cell, passing(c, dvec3(1), -1.2));
    for (int i = 0; i < 2; ++i) c.add("starts behind a middle plane", cell, passing(c, mixed(c), -0.8));
    c.add("the cell lies behind", cell, passing(c, dvec3(1), 8));
    c.group("hard");
    const dvec3 d = whole(c);
    c.add("through the centre", cell, Ray{-4.0 * d, d});
    const double z = c.sign() * c.whole(1, 3) / 2.0;
    c.add("through an edge between four children", cell, Ray{{-4 * d.x, -4 * d.y, z}, {d.x, d.y, 0}});
    c.add("in a middle plane", cell, Ray{{-5, c.sign(), 0}, {1, 0, 0}});
    c.add("in a middle plane, d = -0.0", cell, Ray{{c.sign(), 5, 0}, {0, -1, -0.0}});
    c.add("along the middle of the cell", cell, Ray{{0, 0, 5}, {0, 0, -1}});
}

/// The children in which the ray is, as clear cubes; that which it visits as the k-th is named after the answer's k-th.
Shown show(const Box& b, const Ray& r, const std::vector<int>& right, const std::vector<int>& answer) {
    std::string text;
    std::set<int> named;
    const dvec3 size = (b.hi - b.lo) / 4.0;
    const auto add = [&](int place, int name) {
        if (name < 0 || name > 7 || !named.insert(name).second) return;
        const dvec3 upper(place & 1, (place >> 1) & 1, place >> 2);
        text += generic("child" + std::to_string(name), "cube",
                        glm::scale(glm::translate(dmat4(1), b.lo + size * (1.0 + 2.0 * upper)), 0.99 * size),
                        "clear");
    };
    for (std::size_t k = 0; k < answer.size(); ++k) add(k < right.size() ? right[k] : answer[k], answer[k]);
    return {scene(text, {6, 7, 9}), r};
}
