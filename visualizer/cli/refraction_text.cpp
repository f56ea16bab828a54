#include "visualizer/cli/refraction_text.hpp"

#include "visualizer/cli/ray_facts.hpp"

#include <fmt/format.h>

#include <array>
#include <vector>

namespace rayscope::cli {
namespace {

/// Dots of braille letters: two across and four down in each.
class Dots {
public:
    static constexpr int columns = 36, rows = 10, width = 2 * columns, height = 4 * rows;

    /// From the middle at an angle from the vertical, to the right where it is positive.
    void line(double angle, bool downwards, bool dashed = false) {
        const double length = 0.94 * height / 2;
        for (double s = 1; s < length; s += 0.5)
            if (!dashed || int(s) % 4 < 2)
                set(width / 2 + int(std::lround(s * std::sin(angle))),
                    height / 2 + int(std::lround((downwards ? s : -s) * std::cos(angle))));
    }
    void surface() {
        for (int x = 0; x < width; ++x) set(x, height / 2);
    }
    [[nodiscard]] std::vector<std::string> text() const {
        std::vector<std::string> lines;
        for (int row = 0; row < rows; ++row) {
            std::string line;
            for (int column = 0; column < columns; ++column) {
                const unsigned code = 0x2800U + bits_[std::size_t(row * columns + column)];
                line += char(0xE0U | (code >> 12U));
                line += char(0x80U | ((code >> 6U) & 0x3FU));
                line += char(0x80U | (code & 0x3FU));
            }
            lines.push_back(line);
        }
        return lines;
    }

private:
    void set(int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height) return;
        static constexpr std::array<std::array<unsigned, 4>, 2> dots{{{1, 2, 4, 64}, {8, 16, 32, 128}}};
        bits_[std::size_t(y / 4 * columns + x / 2)] |= dots[std::size_t(x % 2)][std::size_t(y % 4)];
    }
    std::array<unsigned, std::size_t(columns) * rows> bits_{};
};

std::string medium_line(const Trace& trace, Id medium, double speed, const Numbers& number) {
    return medium_name(trace, medium) + ": c = " + number(speed) + ", n = 1/c = " + number(1 / speed);
}

void draw(std::string& text, const RefractionCard& card, const Trace& trace) {
    Dots dots;
    dots.surface();
    dots.line(0, false, true);
    dots.line(0, true, true);
    dots.line(-card.theta_from, false);
    if (card.theta_to) dots.line(*card.theta_to, true);
    if (card.total() || card.reflection != Colour{0}) dots.line(card.theta_from, false, !card.total());
    const Numbers angle(4);
    const auto lines = dots.text();
    for (int row = 0; row < Dots::rows; ++row) {
        text += "  " + lines[std::size_t(row)];
        if (row == 1)
            text += "  " + medium_name(trace, card.medium_from) + ", θ₁ = " + angle.degrees(card.theta_from);
        if (row == 2 && (card.total() || card.reflection != Colour{0}))
            text += "  mirrored at the same angle";
        if (row == Dots::rows - 2)
            text += "  " + medium_name(trace, card.medium_to) +
                    (card.theta_to ? ", θ₂ = " + angle.degrees(*card.theta_to) : ": no ray goes there");
        text += "\n";
    }
}

std::string bend_text(const RefractionCard& card) {
    if (card.total()) return "total internal reflection";
    if (card.eta == 1) return "not bent: the speeds are equal";
    return card.eta < 1 ? "bent towards the normal: light is slower behind the boundary"
                        : "bent away from the normal: light is faster behind the boundary";
}

std::string percent(double share) { return fmt::format("{:.4g} %", 100 * share); }

} // namespace

std::string refraction_text(const Trace& trace, int ray, const StepStyle& style) {
    const Numbers& number = style.number;
    const auto card = refraction_card(trace, ray);
    Page page(style.paint);
    if (!card) {
        page.line(
            "Ray " + std::to_string(ray) +
            " meets no boundary that lets light through; until refraction || tir goes to the next one.");
        return page.text();
    }
    page.heading(card->total() ? "Total internal reflection" : "Refraction");
    std::string text = page.text();
    draw(text, *card, trace);
    Page numbers(style.paint);
    numbers.item("from", medium_line(trace, card->medium_from, card->speed_from, number));
    numbers.item("to", medium_line(trace, card->medium_to, card->speed_to, number));
    numbers.item("Snell", "sin θ₂ = (c₂/c₁) sin θ₁ = " + number(card->eta) + " × " +
                              number(std::sin(card->theta_from)) + " = " +
                              number(card->eta * std::sin(card->theta_from)) +
                              (card->total() ? ", more than 1" : ""));
    numbers.item("θ₁", number.degrees(card->theta_from));
    numbers.item("θ₂", card->theta_to ? number.degrees(*card->theta_to) : "none");
    numbers.item("", bend_text(*card));
    if (const auto beyond = card->beyond_critical())
        numbers.item("critical", "arcsin(c₁/c₂) = " + number.degrees(*card->critical) + "; θ₁ is " +
                                     number.degrees(std::abs(*beyond)) +
                                     (*beyond > 0 ? " beyond it" : " below it"));
    else
        numbers.item("critical", "none: light is not faster behind the boundary");
    numbers.item("Fresnel", "R = " + percent(card->fresnel) + " (s " + percent(card->fresnel_s) + ", p " +
                                percent(card->fresnel_p) + "), T = " + percent(1 - card->fresnel) +
                                ", R + T = 100 %");
    numbers.item("Schlick", "R ≈ " + percent(card->schlick));
    numbers.item("this scene", card->total()
                                   ? "one mirrored ray carries reflection + transmission = " +
                                         number.colour(card->reflection)
                                   : "reflection " + number.colour(card->reflection) + ", transmission " +
                                         number.colour(card->transmission) + ", as the material says");
    return text + numbers.text();
}

} // namespace rayscope::cli
