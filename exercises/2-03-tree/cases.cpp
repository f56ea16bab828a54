#include "cases.hpp"

namespace {

/// Nested: each lies within the one before.
std::vector<Spans> nested(Cases& c) {
    std::vector<Spans> list;
    double a = c.between(-8, -6), b = c.between(6, 8);
    for (int i = 0; i < 4; ++i) {
        list.push_back({{a, b}});
        a += c.between(0.5, 1.4), b -= c.between(0.5, 1.4);
    }
    return list;
}
/// Each begins within the one before, and ends behind it.
std::vector<Spans> stepped(Cases& c) {
    std::vector<Spans> list;
    double a = c.between(-4, -3);
    for (int i = 0; i < 4; ++i, a += c.between(1, 2)) list.push_back({{a, a + c.between(3, 4)}});
    return list;
}

const Node A{'.', 0, 0}, B{'.', 1, 0}, C{'.', 2, 0}, D{'.', 3, 0};

} // namespace

void cases(Cases& c) {
    const std::vector<Node> chain{A, B, C, D, {'&', 0, 1}, {'-', 4, 2}, {'-', 5, 3}};
    c.group("basic");
    c.add("A - B", std::vector<Node>{A, B, {'-', 0, 1}}, 2, nested(c));
    c.add("A | B", std::vector<Node>{A, B, {'|', 0, 1}}, 2, stepped(c));
    c.add("((A & B) - C) - D, nested", chain, 6, nested(c));
    c.add("((A & B) - C) - D, one behind the other", chain, 6, stepped(c));
    c.group("edge");
    const std::vector<Node> twice{A, B, C, {'-', 1, 2}, {'-', 0, 3}};
    c.add("A - (B - C), nested", twice, 4, nested(c));
    c.add("A - (B - C), one behind the other", twice, 4, stepped(c));
    c.add("A - (B | C)", std::vector<Node>{A, B, C, {'|', 1, 2}, {'-', 0, 3}}, 4, nested(c));
    c.add("A & (B | C)", std::vector<Node>{A, B, C, {'|', 1, 2}, {'&', 0, 3}}, 4, stepped(c));
    c.add("a node that is not the last", std::vector<Node>{A, {'-', 0, 2}, B, {'-', 1, 2}}, 1, nested(c));
    c.group("hard");
    c.add("!A", std::vector<Node>{A, {'!', 0, 0}}, 1, nested(c));
    c.add("!(A - B)", std::vector<Node>{A, B, {'-', 0, 1}, {'!', 2, 0}}, 3, nested(c));
    c.add("B & !A, A behind the start", std::vector<Node>{A, B, {'!', 0, 0}, {'&', 1, 2}}, 3,
          std::vector<Spans>{{{-2, -1}}, {{-3, c.between(1, 2)}}});
    const double t = c.between(-1, 1);
    c.add("A | B, which touch", std::vector<Node>{A, B, {'|', 0, 1}}, 2,
          std::vector<Spans>{{{t - 2, t}}, {{t, t + c.between(1, 2)}}});
    c.add("A & B, which touch", std::vector<Node>{A, B, {'&', 0, 1}}, 2,
          std::vector<Spans>{{{t - 2, t}}, {{t, t + c.between(1, 2)}}});
    c.add("A | !A", std::vector<Node>{A, {'!', 0, 0}, {'|', 0, 1}}, 2, nested(c));
}

/// The leaves and the answer, each as slabs across the ray.
Shown show(const std::vector<Node>&, int, const std::vector<Spans>& leaf, const Spans&, const Spans& answer) {
    const Ray r{{0, 0, 0}, {0, 0, -1}};
    std::string text = answer_solids(r, answer);
    for (std::size_t i = 0; i < leaf.size(); ++i)
        text += solids({static_cast<char>('A' + static_cast<int>(i))}, r, leaf[i]);
    return {scene(text, {12, 6, 2}), r};
}
