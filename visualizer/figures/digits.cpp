// What rounding leaves of a far sphere: digits of the chord, by the schoolbook's formula and by the stable one.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace rayscope::figures {
namespace {

constexpr double chart_top = 40, chart_bottom = 470, chart_left = 90, chart_right = 755, chart_decades = 10,
                 most_digits = 17;

template <Numbers N> std::optional<ScalarOf<N>> chord(const Ray<ScalarOf<N>>& ray) {
    const Intervals<ScalarOf<N>> inside = Sphere<N>{}.intervals(ray);
    if (inside.count == 0) return std::nullopt;
    return inside.begin()->exit - inside.begin()->enter;
}

/// Decimal digits of the chord that are right, at each half power of ten; below zero: the sphere is missed.
template <Numbers N> std::vector<double> digits_kept() {
    using T = ScalarOf<N>;
    std::vector<double> kept;
    for (int i = 0; i <= 2 * int(chart_decades); ++i) {
        const Ray<T> ray{{T(-std::round(std::pow(10.0, i / 2.0))), T(0.6), T(0)}, {T(1), T(0), T(0)}};
        const auto found = chord<N>(ray);
        const Float128 exact = *chord<Float128>(as<Float128>(ray));
        if (!found) {
            kept.push_back(-1);
            continue;
        }
        const double error = std::abs(double((Float128(*found) - exact) / exact));
        kept.push_back(std::clamp(-std::log10(std::max(error, 1e-17)), 0.0, most_digits));
    }
    return kept;
}

Pixel on_chart(double decade, double digits) {
    return {chart_left + (chart_right - chart_left) * decade / chart_decades,
            chart_bottom - (chart_bottom - chart_top) * digits / most_digits};
}

struct Curve {
    const char* name;
    std::vector<double> kept;
    Rgb colour;
    bool textbook;
};

void draw_curve(Svg& svg, const Curve& curve) {
    std::vector<Pixel> line;
    Pixel end;
    bool missed = false;
    for (std::size_t i = 0; i < curve.kept.size() && !missed; ++i) {
        missed = curve.kept[i] < 0;
        line.push_back(end = on_chart(double(i) / 2, std::max(curve.kept[i], 0.0)));
    }
    svg.path(line, {curve.colour, 3, curve.textbook ? "9 5" : ""});
    for (const Pixel& p : line) {
        if (curve.textbook)
            svg.diamond(p, 7, curve.colour);
        else
            svg.dot(p, 6, curve.colour);
    }
}

} // namespace

Svg cancellation(const Subject& /*no scene: a sphere alone*/) {
    Svg svg(1000, 560);
    for (int digits = 0; digits <= 16; digits += 4) {
        svg.line(on_chart(0, digits), on_chart(chart_decades, digits), {pale, 1.5});
        svg.text({chart_left - 14, on_chart(0, digits).y}, std::to_string(digits),
                 {19, black, false, Anchor::end});
    }
    constexpr const char* powers[] = {"1", "100", "10⁴", "10⁶", "10⁸", "10¹⁰"};
    for (int i = 0; i <= 5; ++i) {
        svg.line({on_chart(2 * i, 0).x, chart_bottom}, {on_chart(2 * i, 0).x, chart_bottom + 8}, {black, 2});
        svg.text({on_chart(2 * i, 0).x, chart_bottom + 28}, powers[i], {19});
    }
    svg.line(on_chart(0, 0), on_chart(chart_decades, 0), {black, 2});
    svg.line(on_chart(0, 0), on_chart(0, most_digits), {black, 2});
    svg.text({chart_left - 60, 18}, "right digits of the chord", {20, black, true, Anchor::start});
    svg.text({(chart_left + chart_right) / 2, chart_bottom + 64},
             "distance of the ray's start from a sphere of radius 1", {20, black, true});
    const Curve curves[] = {{"float, textbook", digits_kept<Textbook<float>>(), vermilion, true},
                            {"float, stable", digits_kept<float>(), orange, false},
                            {"double, textbook", digits_kept<Textbook<double>>(), blue, true},
                            {"double, stable", digits_kept<double>(), sky_blue, false}};
    double y = 70;
    for (const Curve& curve : {curves[3], curves[2], curves[1], curves[0]}) {
        const double x = chart_right + 30;
        svg.line({x - 8, y}, {x + 28, y}, {curve.colour, 3, curve.textbook ? "9 5" : ""});
        svg.text({x + 36, y}, curve.name, {18, black, false, Anchor::start});
        y += 40;
        draw_curve(svg, curve);
    }
    svg.text({chart_right + 22, chart_bottom - 14}, "0: the sphere", {18, black, false, Anchor::start});
    svg.text({chart_right + 22, chart_bottom + 10}, "is missed", {18, black, false, Anchor::start});
    return svg;
}

} // namespace rayscope::figures
