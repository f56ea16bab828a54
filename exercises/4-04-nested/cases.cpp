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
