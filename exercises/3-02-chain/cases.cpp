#include "cases.hpp"

namespace {

std::vector<Bounce> path(Cases& c, int mirrors, bool matt_end) {
    std::vector<Bounce> list;
    for (int i = 0; i < mirrors; ++i) list.push_back({c.vector(0.1, 1), c.between(0.3, 0.9)});
    if (matt_end) list.push_back({c.vector(0.1, 1), 0});
    return list;
}

} // namespace

void cases(Cases& c) {
    const auto sky = [&] { return c.vector(0.2, 1); };
    c.group("basic");
    c.add("a matt wall", path(c, 0, true), 8, sky());
    for (int i = 0; i < 2; ++i) c.add("a mirror, then a matt wall", path(c, 1, true), 8, sky());
    c.add("two mirrors, then a matt wall", path(c, 2, true), 8, sky());
    c.group("edge");
    c.add("a mirror, then nothing", path(c, 1, false), 8, sky());
    c.add("two mirrors, then nothing", path(c, 2, false), 8, sky());
    c.add("k = 0", path(c, 2, true), 0, sky());
    c.add("k = 1", path(c, 2, true), 1, sky());
    c.add("k = 1, and the ray escapes", path(c, 1, false), 1, sky());
    c.add("no surface", std::vector<Bounce>{}, 3, sky());
    c.group("hard");
    c.add("five bounces", path(c, 5, true), 8, sky());
    c.add("five bounces, then nothing", path(c, 5, false), 5, sky());
    c.add("five bounces, k = 3", path(c, 5, true), 3, sky());
    c.add("five bounces, k = 4, then nothing", path(c, 5, false), 4, sky());
}
