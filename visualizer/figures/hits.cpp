// Two spheres, their hits, their lists, and all that can be made of them.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"

namespace rayscope::figures {
namespace {

const Ray<double> through_both{{-4, 0, 0}, {1, 0, 0}};

} // namespace

Svg two_spheres_hits(const Subject& subject) {
    Svg svg(1000, 590);
    const Sheet sheet{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {540, 180}, 120};
    const Workbench both = apart(subject.bench.scene, {"A", "B"});
    const auto lists = [&](std::size_t i) {
        return [&both, i](const Ray<double>& ray) { return list_of(both, ray, i); };
    };
    const auto a = section(sheet, -1.2, 1.2, lists(0)), b = section(sheet, -1.2, 1.2, lists(1));
    const auto common =
        section(sheet, -1.2, 1.2, [&](const Ray<double>& ray) { return list_of(subject.bench, ray); });
    svg.area(a, {sky_blue, 0.35});
    svg.area(b, {orange, 0.35});
    svg.area(common, {green, 0.45});
    svg.outline(a.at(0), {blue, 2.5});
    svg.outline(b.at(0), {vermilion, 2.5, "9 5"});
    svg.text({446, 100}, "A", {30, blue, true});
    svg.text({634, 100}, "B", {30, vermilion, true});
    svg.text({540, 232}, "A ∩ B", {19, black, true});

    const Trace trace = trace_ray(subject.bench, through_both);
    const List in_a = list_of(trace, 0, "A"), in_b = list_of(trace, 0, "B"),
               in_both = list_of(trace, 0, "common");
    const Line line{sheet(through_both.origin).x, sheet.scale, 0, 7, 46, 20};
    const double first_lane = 370;
    struct Label {
        double t;
        const char* name;
        Rgb colour;
    };
    const Label labels[] = {{in_a.at(0).first, "t₁", blue},
                            {in_a.at(0).second, "t₂", blue},
                            {in_b.at(0).first, "t₃", vermilion},
                            {in_b.at(0).second, "t₄", vermilion}};
    for (const Label& label : labels)
        svg.line({line(label.t), 190}, {line(label.t), 490}, {grey, 1.5, "3 5"});
    const Pixel eye = sheet(through_both.origin);
    svg.arrow(eye, {line(7.2), eye.y}, {black, 3});
    svg.dot(eye, 8, black);
    svg.text({eye.x, eye.y - 26}, "ray, t = 0", {20, black, false, Anchor::start});
    for (const Label& label : labels) {
        svg.dot({line(label.t), eye.y}, 7, label.colour);
        svg.text({line(label.t) + 22, eye.y - 24}, label.name, {24, label.colour, true});
    }
    draw_lanes(svg, {line.at, line.scale, 0.9, 7, 46, 20}, first_lane,
               {{"inside A", in_a, sky_blue}, {"inside B", in_b, orange}, {"in A ∩ B", in_both, green}});
    return svg;
}

Svg hit_lists(const Subject& subject) {
    Svg svg(1000, 400);
    const Trace trace = trace_ray(subject.bench, through_both);
    const List a = list_of(trace, 0, "A"), b = list_of(trace, 0, "B");
    const auto made = [&](auto holds) {
        return combined({a, b}, 0, 8, [&](const std::vector<bool>& in) { return holds(in[0], in[1]); });
    };
    const Line line{20, 140, 1.4, 6.6, 48, 40};
    for (const double t : {a[0].first, a[0].second, b[0].first, b[0].second})
        svg.line({line(t), 20}, {line(t), 336}, {grey, 1.5, "3 5"});
    draw_lanes(svg, line, 46,
               {{"A", a, sky_blue},
                {"B", b, orange},
                {"A ∪ B", made([](bool x, bool y) { return x || y; }), green},
                {"A ∩ B", made([](bool x, bool y) { return x && y; }), green},
                {"A − B", made([](bool x, bool y) { return x && !y; }), green},
                {"B − A", made([](bool x, bool y) { return y && !x; }), green}});
    svg.line({30, 118}, {960, 118}, {grey, 1.5});
    return svg;
}

Svg sixteen_functions(const Subject& subject) {
    // Bit 0: the part outside of both, bit 1: of A alone, bit 2: of B alone, bit 3: of both.
    struct Function {
        int parts;
        const char* name;
    };
    constexpr Function functions[] = {{0, "∅"},   {8, "A ∩ B"},    {2, "A − B"},     {4, "B − A"},
                                      {10, "A"},  {12, "B"},       {6, "A △ B"},     {14, "A ∪ B"},
                                      {15, "¬∅"}, {7, "¬(A ∩ B)"}, {13, "¬(A − B)"}, {11, "¬(B − A)"},
                                      {5, "¬A"},  {3, "¬B"},       {9, "¬(A △ B)"},  {1, "¬(A ∪ B)"}};
    Svg svg(1000, 800);
    const Workbench both = apart(subject.bench.scene, {"A", "B"});
    constexpr double half_width = 1.9, half_height = 1.25;
    int place = 0;
    for (const Function& function : functions) {
        const double x = 130 + 247 * (place % 4), y = 80 + 194 * (place / 4);
        ++place;
        const Sheet sheet{{-half_width, 0, 0}, {1, 0, 0}, {0, 1, 0}, {x - half_width * 58, y}, 58};
        const auto chosen = [&](const Ray<double>& ray) {
            return combined({list_of(both, ray, 0), list_of(both, ray, 1)}, 0, 2 * half_width,
                            [&](const std::vector<bool>& in) {
                                return (function.parts >> (in[0] + 2 * in[1]) & 1) != 0;
                            });
        };
        svg.area(section(sheet, -half_height, half_height, chosen), {place <= 8 ? sky_blue : orange, 0.8});
        for (const std::size_t i : {0, 1}) {
            const auto cut = section(sheet, -half_height, half_height,
                                     [&](const Ray<double>& ray) { return list_of(both, ray, i); });
            svg.outline(cut.at(0), {black, 1.8});
        }
        svg.frame({x - half_width * 58, y - half_height * 58, 2 * half_width * 58, 2 * half_height * 58},
                  {grey, 1.2});
        svg.text({x, y + half_height * 58 + 19}, function.name, {20, black, true});
    }
    svg.text({500, 788}, "blue: bounded; orange: without end.  A △ B is (A − B) ∪ (B − A)", {20});
    return svg;
}

} // namespace rayscope::figures
