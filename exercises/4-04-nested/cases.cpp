#include "cases.hpp"

void cases(Cases& c) {
    using Path = std::vector<Cross>;
    const auto some = [&] {
        return std::vector<double>{c.between(0.4, 0.55), c.between(0.6, 0.7), c.between(0.75, 0.9)};
    };
    const std::vector<int> none, equal{0, 0, 0}, outer{2, 1, 0}, inner{0, 1, 2};
    c.group("basic");
    c.add("through glass", Path{{0, true}, {0, false}}, none, some(), equal);
    c.add("through glass twice", Path{{0, true}, {0, false}, {0, true}, {0, false}}, none, some(), equal);
    c.add("through two", Path{{1, true}, {1, false}, {2, true}, {2, false}}, none, some(), inner);
    c.group("edge");
    c.add("a bubble in glass", Path{{0, true}, {1, true}, {1, false}, {0, false}}, none, some(), inner);
    c.add("a bubble in glass in water",
          Path{{0, true}, {1, true}, {2, true}, {2, false}, {1, false}, {0, false}}, none, some(), equal);
    c.add("the eye is under water", Path{{1, true}, {1, false}}, std::vector<int>{0}, some(), inner);
    c.add("the eye is under water and comes out", Path{{0, false}, {1, true}, {1, false}},
          std::vector<int>{0}, some(), equal);
    c.group("hard");
    const Path one{{0, true}, {1, true}, {0, false}, {1, false}},
        other{{1, true}, {0, true}, {1, false}, {0, false}};
    const auto speed = some();
    c.add("an overlap, entered by the lower priority", one, none, speed, inner);
    c.add("an overlap, entered by the higher priority", other, none, speed, inner);
    c.add("the same overlap, other priorities", one, none, speed, outer);
    c.add("the same overlap the other way", other, none, speed, outer);
    c.add("equal priorities", other, none, speed, equal);
    c.add("three overlap, the eye in two", Path{{2, true}, {0, false}, {1, false}, {2, false}},
          std::vector<int>{1, 0}, speed, outer);
}

namespace {

/// Layers across the z axis, the crossing i at z = -1 - i.
std::string layers(const std::vector<Cross>& p, const std::vector<int>& in, const std::vector<double>& c,
                   const std::vector<int>& priority) {
    std::string text;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const std::string medium = "medium" + std::to_string(i);
        text +=
            "\n[materials." + medium + "]\ndiffuse = 0.1\ntransmission = 0.9\nspeed = " + digits(c[i]) + "\n";
        int number = 0;
        const auto add = [&](const char* shape, const dmat4& m) {
            const std::string name = "object" + std::to_string(i) + (number++ == 0 ? "" : "_again");
            text += generic(name, shape, m, medium) + "priority = " + std::to_string(priority[i]) + "\n";
        };
        bool inside = std::ranges::find(in, static_cast<int>(i)) != in.end();
        double begin = 2;
        for (std::size_t k = 0; k < p.size(); ++k) {
            if (p[k].obj != static_cast<int>(i)) continue;
            const double z = -1.0 - static_cast<double>(k);
            if (inside)
                add("cube", glm::scale(glm::translate(dmat4(1), dvec3(0, 0, (begin + z) / 2)),
                                       dvec3(20, 20, (begin - z) / 2)));
            inside = p[k].enter;
            begin = z;
        }
        if (inside) add("plane", glm::translate(dmat4(1), dvec3(0, 0, begin)));
    }
    return text;
}

/// The speeds if of several media that rules which is offered last.
std::vector<dvec2> by_order(const std::vector<Cross>& p, std::vector<int> in, const std::vector<double>& c) {
    const auto speed = [&] { return in.empty() ? 1.0 : c[static_cast<std::size_t>(in.back())]; };
    std::vector<dvec2> list;
    for (const Cross& cross : p) {
        const double before = speed();
        if (cross.enter)
            in.push_back(cross.obj);
        else
            std::erase(in, cross.obj);
        list.emplace_back(before, speed());
    }
    return list;
}

/// A priority for each object: the later it is entered, the higher.
std::vector<int> ranks(const std::vector<Cross>& p, const std::vector<int>& in, std::size_t objects) {
    std::vector<int> list(objects, 0);
    int next = 0;
    for (const int object : in) list[static_cast<std::size_t>(object)] = ++next;
    for (const Cross& cross : p)
        if (cross.enter) list[static_cast<std::size_t>(cross.obj)] = ++next;
    return list;
}

} // namespace

/// The objects as layers. Of answers those are drawn that other priorities would give, or an eye in air.
Shown show(const std::vector<Cross>& p, std::vector<int> in, const std::vector<double>& c,
           std::vector<int> priority, const std::vector<dvec2>& right, const std::vector<dvec2>& answer) {
    if (answer != right && answer == by_order(p, in, c))
        priority = ranks(p, in, c.size());
    else if (answer != right && !answer.empty() && answer.front().x == 1)
        in.clear();
    return {scene(layers(p, in, c, priority), {6, -8, 2}, {0, 0, -3}), {{0, 0, 0}, {0.1, 0, -1}}};
}
