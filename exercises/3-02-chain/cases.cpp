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

namespace {

/// The colour of a path that ends behind `surfaces` of its surfaces.
dvec3 colour(const std::vector<Bounce>& p, int surfaces, int k, const dvec3& bg) {
    dvec3 sum(0);
    double weight = 1;
    for (int i = 0; i < surfaces; ++i) {
        const Bounce& at = p[static_cast<std::size_t>(i)];
        sum += weight * at.local;
        if (i == k || at.kr == 0) return sum;
        weight *= at.kr;
    }
    return sum + weight * bg;
}

/// Between floor and ceiling: a mirror wherever the ray comes to.
std::string plates(const std::vector<Bounce>& p, int surfaces) {
    std::string text;
    for (int i = 0; i < surfaces; ++i) {
        const Bounce& at = p[static_cast<std::size_t>(i)];
        const std::string name = "surface" + std::to_string(i);
        text += "\n[materials." + name + "]\nambient = " + list(at.local) +
                "\ndiffuse = 0\nreflection = " + digits(at.kr) + "\n";
        const dvec3 place(i, 0, i % 2 == 0 ? -0.01 : 1.01);
        text += generic(name, "cube", glm::scale(glm::translate(dmat4(1), place), {0.3, 0.3, 0.01}), name);
    }
    return text;
}

} // namespace

/// The path as a zig-zag. An answer is drawn that a path which ends elsewhere would give.
Shown show(const std::vector<Bounce>& p, int k, const dvec3& bg, const dvec3& right, const dvec3& answer) {
    const int all = static_cast<int>(p.size());
    int surfaces = all, rays = k;
    for (int s = all; s >= 0 && answer != right; --s)
        for (int r = s; r >= 0; --r)
            if (glm::all(glm::lessThan(glm::abs(colour(p, s, r, bg) - answer), dvec3(1e-9))))
                surfaces = s, rays = r;
    return {"[scene]\nbackground = " + list(bg) + "\n\n[limits]\nmax_depth = " + std::to_string(rays) +
                "\nmin_weight = 0\n\n" + scene(plates(p, surfaces), {2, -6, 2}, {2, 0, 0.5}),
            {{-0.5, 0, 0.5}, {1, 0, -1}}};
}
