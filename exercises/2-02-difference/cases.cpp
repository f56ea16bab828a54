#include "cases.hpp"

namespace {

Hits hits(Cases& c, std::vector<double> times, int obj, bool enter = true) {
    Hits list;
    for (const double t : times) {
        list.push_back({t, c.unit(), enter, obj});
        enter = !enter;
    }
    return list;
}

/// Ascending, each about 1 after the other, from `first`.
std::vector<double> times(Cases& c, int count, double first) {
    std::vector<double> list;
    for (int i = 0; i < count; ++i) list.push_back(first + i + c.between(0.1, 0.9));
    return list;
}

} // namespace

void cases(Cases& c) {
    c.group("basic");
    const auto four = times(c, 4, 0);
    c.add("B cuts the far end", hits(c, {four[0], four[2]}, 1), hits(c, {four[1], four[3]}, 2));
    c.add("B cuts the near end", hits(c, {four[1], four[3]}, 1), hits(c, {four[0], four[2]}, 2));
    c.add("apart", hits(c, {four[0], four[1]}, 1), hits(c, {four[2], four[3]}, 2));
    c.add("B lies within A", hits(c, {four[0], four[3]}, 1), hits(c, {four[1], four[2]}, 2));
    c.add("A lies within B", hits(c, {four[1], four[2]}, 1), hits(c, {four[0], four[3]}, 2));
    c.add("B is missed", hits(c, {four[0], four[3]}, 1), Hits{});
    c.group("edge");
    const auto many = times(c, 12, -4);
    c.add("many spans", hits(c, {many[0], many[3], many[5], many[9]}, 1),
          hits(c, {many[1], many[2], many[4], many[6], many[8], many[11]}, 2));
    c.add("A comes from inside", hits(c, {many[2], many[4], many[9]}, 1, false),
          hits(c, {many[0], many[1]}, 2));
    c.add("B comes from inside", hits(c, {many[1], many[6]}, 1),
          hits(c, {many[3], many[5], many[7]}, 2, false));
    c.add("both stay inside", hits(c, {many[1]}, 1), hits(c, {many[4]}, 2));
    c.add("A is missed", Hits{}, hits(c, {many[0], many[1]}, 2));
    c.group("hard");
    const auto t = times(c, 5, -2);
    c.add("they begin together", hits(c, {t[0], t[3]}, 1), hits(c, {t[0], t[2]}, 2));
    c.add("they end together", hits(c, {t[0], t[3]}, 1), hits(c, {t[1], t[3]}, 2));
    c.add("A - A", hits(c, {t[0], t[3]}, 1), hits(c, {t[0], t[3]}, 2));
    c.add("B ends where A begins", hits(c, {t[2], t[4]}, 1), hits(c, {t[0], t[2]}, 2));
    c.add("B begins where A ends", hits(c, {t[0], t[2]}, 1), hits(c, {t[2], t[4]}, 2));
    c.add("A begins again where B ends", hits(c, {t[0], t[1], t[3], t[4]}, 1), hits(c, {t[2], t[3]}, 2));
}

namespace {

/// A union of slabs across the ray that runs down from z = 0.
std::string slabs(const std::string& name, const Hits& hits) {
    std::string parts, expression;
    double begin = -20;
    const auto add = [&](double end) {
        const std::string part = name + std::to_string(expression.size());
        const dmat4 move = glm::translate(dmat4(1), dvec3(0, 0, -(begin + end) / 2));
        parts += generic(part, "cube", glm::scale(move, dvec3(1, 1, (end - begin) / 2)));
        expression += (expression.empty() ? "" : " | ") + part;
    };
    for (const Hit& hit : hits) {
        if (hit.enter)
            begin = hit.t;
        else
            add(hit.t);
    }
    if (!hits.empty() && hits.back().enter) add(20);
    if (expression.empty()) {
        parts += generic(name + "0", "cube", glm::translate(dmat4(1), dvec3(50, 0, 0)));
        expression = name + "0";
    }
    return parts + "\n[compounds." + name + "]\nis = \"" + expression + "\"\n";
}

} // namespace

Shown show(const Hits& A, const Hits& B) {
    return {scene(slabs("A", A) + slabs("B", B) + "\n[compounds.rest]\nis = \"A - B\"\nmaterial = \"matt\"\n",
                  {12, 6, 2}),
            {{0, 0, 0}, {0, 0, -1}}};
}
