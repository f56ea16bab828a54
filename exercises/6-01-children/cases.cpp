#include "cases.hpp"

namespace {

/// In quarters, so that middles are exact.
Box cell(Cases& c) {
    const dvec3 lo(c.whole(-8, 8) / 4.0, c.whole(-8, 8) / 4.0, c.whole(-8, 8) / 4.0);
    return {lo, lo + dvec3(4, 2 * c.whole(1, 3), 4)};
}
/// At shares of the cell: 0 its lower, 1 its upper end.
Box at(const Box& cell, const dvec3& lo, const dvec3& hi) {
    return {cell.lo + lo * (cell.hi - cell.lo), cell.lo + hi * (cell.hi - cell.lo)};
}

} // namespace

void cases(Cases& c) {
    const auto low = [&] { return c.between(0.1, 0.2); };
    const auto high = [&] { return c.between(0.6, 0.7); };
    const double size = c.between(0.1, 0.2);
    const Box b = cell(c);
    c.group("basic");
    c.add("upper x alone", b, at(b, {high(), low(), low()}, {high() + size, low() + size, low() + size}));
    c.add("upper z alone", b, at(b, {low(), low(), high()}, {low() + size, low() + size, high() + size}));
    c.add("upper y and z", b, at(b, {low(), high(), high()}, {low() + size, high() + size, high() + size}));
    c.add("two children", b, at(b, {low(), low(), low()}, {high(), low() + size, low() + size}));
    c.add("four children", b, at(b, {low(), low(), high()}, {high(), high(), high() + size}));
    c.group("edge");
    c.add("larger than the cell", b, at(b, {-1, -2, -1}, {2, 2, 3}));
    c.add("larger than the cell, but for its upper x", b, at(b, {-1, -1, -1}, {low(), 2, 2}));
    c.add("reaches in from outside", b, at(b, {high(), -1, -1}, {3, 2, low()}));
    c.add("outside", b, at(b, {c.between(1.1, 2), 0, 0}, {3, 1, 1}));
    c.group("hard");
    c.add("touches the middle from below", b,
          at(b, {low(), low(), low()}, {0.5, low() + size, low() + size}));
    c.add("touches the middle from above", b,
          at(b, {low(), 0.5, high()}, {low() + size, 0.75, high() + size}));
    c.add("touches the cell from outside", b, at(b, {-1, low(), low()}, {0, high(), low() + size}));
    c.add("a flat object in the middle plane", b, at(b, {low(), low(), 0.5}, {low() + size, high(), 0.5}));
    c.add("a point at the centre", b, at(b, dvec3(0.5), dvec3(0.5)));
}

namespace {

dvec3 upper(unsigned child) { return {child & 1U, (child >> 1U) & 1U, child >> 2U}; }
dvec3 middle(const Box& cell, unsigned child) {
    return cell.lo + (cell.hi - cell.lo) * (0.25 + 0.5 * upper(child));
}

/// Clear, and a little smaller, so that no two of them touch.
std::string cube(const Box& cell, unsigned child) {
    return generic("child" + std::to_string(child), "cube",
                   glm::scale(glm::translate(dmat4(1), middle(cell, child)), 0.2475 * (cell.hi - cell.lo)),
                   "clear");
}

} // namespace

/// The object, and the children that are listed. The ray comes from beside the cell into one that is wrong.
Shown show(const Box& cell, const Box& obj, unsigned right, unsigned drawn, unsigned answer) {
    std::string text;
    for (unsigned k = 0; k < 8; ++k)
        if ((drawn >> k & 1U) != 0) text += cube(cell, k);
    const dvec3 half = glm::max((obj.hi - obj.lo) / 2.0, dvec3(0.001));
    text += generic("object", "cube", glm::scale(glm::translate(dmat4(1), (obj.lo + obj.hi) / 2.0), half),
                    "clear");
    const unsigned wrong = (right ^ answer) & 0xFFU;
    const unsigned child = wrong == 0 ? 0 : static_cast<unsigned>(std::countr_zero(wrong));
    const dvec3 out((child & 1U) != 0 ? 1 : -1, 0, 0);
    return {scene(text, cell.hi + dvec3(4, 5, 6), (cell.lo + cell.hi) / 2.0),
            {middle(cell, child) + out * (cell.hi - cell.lo) / 2.0, -out},
            "The case has no ray. This one goes into child " + std::to_string(child) +
                " of the cell; drawn are the children that an answer lists."};
}
