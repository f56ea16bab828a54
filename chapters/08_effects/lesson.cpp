// Chapter 8: which effects the scenes call for, how much a boundary reflects, and where the light of a scene comes from.

#include "core/rayscope.hpp"

#include <fmt/format.h>

#include <numbers>

using namespace rayscope;

namespace {

const std::string scenes = RAYSCOPE_CHAPTERS "/08_effects/";
constexpr double degree = std::numbers::pi / 180;

void found_effects() {
    const std::vector<std::string> names{"still_life", "ice_water", "rainbow", "diamond", "mirror_bowl"};
    std::vector<EffectSet> found;
    std::string head(16, ' ');
    for (const std::string& name : names) {
        const Workbench bench = open(scenes + name + ".toml");
        found.push_back(needed_effects(effect_needs(bench.scene, bench.world)));
        head += fmt::format("{:<12}", name);
    }
    fmt::print("Effects that the scenes call for\n{}\n", head.substr(0, head.find_last_not_of(' ') + 1));
    for (std::size_t effect = 0; effect < effect_names.size(); ++effect) {
        std::string row = fmt::format("  {:<14}", effect_names[effect].name);
        for (const EffectSet& set : found)
            row += fmt::format("{:<12}", set.has(Effect(effect)) ? "yes" : "-");
        fmt::print("{}\n", row.substr(0, row.find_last_not_of(' ') + 1));
    }
    fmt::print("\n");
}

struct Shares {
    double perpendicular, parallel, schlick;
};

/// Fresnel's equations and Schlick's approximation, from index n1 into n2.
Shares reflected_shares(double n1, double n2, double theta) {
    const double sine = n1 / n2 * std::sin(theta);
    if (sine > 1) return {1, 1, 1};
    const double cos1 = std::cos(theta), cos2 = std::sqrt(1 - sine * sine);
    const auto square = [](double x) { return x * x; };
    const double r0 = square((n1 - n2) / (n1 + n2)), x = 1 - (n1 > n2 ? cos2 : cos1);
    return {square((n1 * cos1 - n2 * cos2) / (n1 * cos1 + n2 * cos2)),
            square((n2 * cos1 - n1 * cos2) / (n2 * cos1 + n1 * cos2)), r0 + (1 - r0) * std::pow(x, 5)};
}

void print_shares(const char* title, double n1, double n2, std::initializer_list<double> angles) {
    fmt::print("{}\n", title);
    for (const double theta : angles) {
        const Shares r = reflected_shares(n1, n2, theta * degree);
        const double mean = (r.perpendicular + r.parallel) / 2;
        fmt::print("  {:>5.2f}°  Rs {:.4f}  Rp {:.4f}  R {:.4f}  goes through {:.4f}  Schlick {:.4f}\n",
                   theta, r.perpendicular, r.parallel, mean, 1 - mean, r.schlick);
    }
    fmt::print("\n");
}

void small_formulas() {
    fmt::print("Three formulas\n");
    const double radius = 0.7, light = 5, edge = 1; // of a lamp at height 5, past an edge at height 1
    fmt::print("  penumbra     2 r h / (H - h) = {:.4f}\n", 2 * radius * edge / (light - edge));
    fmt::print("  absorption   exp(-0.5 * 2) = {:.4f} of the light is left after 2 units\n",
               std::exp(-0.5 * 2));
    for (const double n : {1.5, 1.6})
        fmt::print("  prism of 60°, n = {}: turns a ray by {:.4f}° at least\n", n,
                   (2 * std::asin(n * std::sin(30 * degree)) - 60 * degree) / degree);
    fmt::print("\n");
}

void energy() {
    const Workbench bench = open(scenes + "mirror_bowl.toml");
    const Ledger book = ledger(bench, 64, 48);
    constexpr std::string_view rays[] = {"eye", "reflected", "refracted"};
    const auto sum = [](const Colour& c) { return c.x + c.y + c.z; };
    fmt::print("Where the light of mirror_bowl comes from, 64 × 48 pixels\n");
    double whole = 0;
    for (std::size_t kind = 0; kind < 3; ++kind) {
        double share = 0;
        for (const auto& [source, colour] : book.sources)
            if (source.brought_by == RayKind(kind)) share += sum(colour);
        whole += share;
        fmt::print("  brought by {:<9} rays  {:>5.1f} %\n", rays[kind], 100 * share / sum(book.total));
    }
    fmt::print("  all of it                  {:>5.1f} %\n", 100 * whole / sum(book.total));
    fmt::print("  swallowed by media, as it would have arrived  {:.1f} %\n",
               100 * sum(book.absorbed) / sum(book.total));
    for (const auto& [what, dropped] : book.dropped)
        fmt::print("  not followed, {:<9} for its {}: a weight of {:.6f} of each pixel, in the mean\n",
                   rays[std::size_t(what.first)], what.second == Reason::depth ? "depth" : "weight",
                   largest_component(dropped.weight));
}

} // namespace

int main() {
    found_effects();
    print_shares("From air into glass of index 1.5", 1, 1.5,
                 {0, 30, 45, std::atan(1.5) / degree, 75, 85, 89.9});
    print_shares("From glass into air", 1.5, 1, {0, 20, 30, 40, 41.8, 41.9});
    small_formulas();
    energy();
}
