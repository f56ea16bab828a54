// Chapter 4: Snell's law about the critical angle, the vector formula, and where total reflection can happen at all.

#include "core/rayscope.hpp"

#include <fmt/format.h>

#include <numbers>

using namespace rayscope;

namespace {

const std::string scenes = RAYSCOPE_CHAPTERS "/04_refraction/";

double degrees(double radians) { return radians * 180 / std::numbers::pi; }
double radians(double degrees) { return degrees * std::numbers::pi / 180; }

std::string text(const Vec3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0); // + 0.0: no −0
}

/// How a ray went on where it met a boundary of two media, as it was recorded.
std::string answer(const TracedRay& ray) {
    if (const auto* bent = ray.find<Refracted>())
        return fmt::format("bent to {:.4f}°", degrees(bent->theta_to));
    return ray.find<TotallyReflected>() != nullptr ? "totally reflected" : "no transparent boundary";
}

void about_the_critical_angle() {
    const Workbench lake = open(scenes + "water.toml");
    fmt::print("From water into air, c₁ / c₂ = {:.4f}\n", 1 / 1.33);
    for (const double theta : {0.0, 15.0, 30.0, 45.0, 48.0, 48.7, 48.75, 48.76, 49.0, 60.0, 89.0}) {
        const Ray<double> up{{0, -1, 0}, {std::sin(radians(theta)), std::cos(radians(theta)), 0}};
        fmt::print("  θ₁ = {:>5}°  {}\n", theta, answer(trace_ray(lake, up).rays.front()));
    }
    fmt::print("  the critical angle is {:.4f}°\n\n", degrees(std::asin(1 / 1.33)));
}

/// d and n unit, n against d; eta = c₂ / c₁. Nothing at total internal reflection.
std::optional<Vec3d> refracted_direction(const Vec3d& d, const Vec3d& n, double eta) {
    const double cosine = -dot(n, d);                              // of θ₁
    const double radicand = 1 - eta * eta * (1 - cosine * cosine); // cos² θ₂
    if (radicand < 0) return std::nullopt;
    return eta * d + (eta * cosine - std::sqrt(radicand)) * n;
}

/// What the notes print: η d + [η n·d − √k] n.
Vec3d printed_direction(const Vec3d& d, const Vec3d& n, double eta) {
    const double along = dot(n, d), radicand = 1 - eta * eta * (1 - along * along);
    return eta * d + (eta * along - std::sqrt(radicand)) * n;
}

void formulas() {
    fmt::print("30° from above, n = (0, 0, 1)\n");
    const Vec3d d{0.5, 0, -std::sqrt(0.75)}, n{0, 0, 1};
    for (const double eta : {1.0, 1 / 1.5}) {
        const Vec3d t = *refracted_direction(d, n, eta);
        const Vec3d printed = printed_direction(d, n, eta), turned = printed_direction(d, -n, eta);
        fmt::print("  η = {:.6f}, θ₂ = {:.4f}°\n", eta, degrees(std::atan2(t.x, -t.z)));
        fmt::print("    right               t = {}, length {:.6f}\n", text(t), length(t));
        fmt::print("    as printed          t = {}, length {:.6f}\n", text(printed), length(printed));
        fmt::print("    as printed, with -n t = {}, length {:.6f}\n", text(turned), length(turned));
    }
    fmt::print("\n");
}

/// Follows the rays that go through, boundary after boundary.
void print_boundaries(const Trace& trace) {
    for (int at = 0; at != none;) {
        const TracedRay& ray = trace.rays[std::size_t(at)];
        const auto* hit = ray.find<BoundaryChosen>();
        const auto* bent = ray.find<Refracted>();
        const auto* total = ray.find<TotallyReflected>();
        if (hit == nullptr || (bent == nullptr && total == nullptr)) break;
        fmt::print(
            "  {} {}: c₁ = {:.4f}, c₂ = {:.4f}, n·d = {:+.4f}\n    θ₁ = {:.4f}°, {}; local light: {}\n",
            hit->entering ? "enters" : "leaves", trace.objects[std::size_t(hit->object)].name,
            hit->speed_from, hit->speed_to, dot(hit->normal, ray.start().direction),
            degrees(bent != nullptr ? bent->theta_from : total->theta_from), answer(ray),
            ray.find<LocalLightSkipped>() != nullptr ? "no" : "yes");
        const auto next = children_of(trace, ray, bent != nullptr ? RayKind::refracted : RayKind::reflected);
        at = next.empty() ? none : next.front();
    }
    fmt::print("\n");
}

void balls() {
    const Workbench ball = open(scenes + "glass_ball.toml"), bubble = open(scenes + "bubble.toml");
    fmt::print("A ball of glass in air, and a bubble of air in water, hit x beside the middle\n");
    for (const double x : {0.2, 0.5, 0.7, 0.76, 0.9, 0.999}) {
        const Ray<double> ray{{x, 0, 5}, {0, 0, -1}};
        const Trace through = trace_ray(ball, ray);
        const auto inside = children_of(through, through.rays.front(), RayKind::refracted);
        fmt::print("  x = {:<5}  ball {}, at the far wall {}\n             bubble {}\n", x,
                   answer(through.rays.front()), answer(through.rays[std::size_t(inside.front())]),
                   answer(trace_ray(bubble, ray).rays.front()));
    }
    fmt::print("\n");
}

void glass_in_water() {
    const Ray<double> inside{{0, -0.5, 0}, {1, 1, 0}};
    fmt::print("In glass under water, 45° onto the wall\n");
    Workbench bench = open(scenes + "glass_in_water.toml");
    for (const bool notes : {false, true}) {
        bench.world.notes_media = notes;
        const TracedRay first = trace_ray(bench, inside).rays.front();
        const auto* hit = first.find<BoundaryChosen>();
        fmt::print("  {} c₁ = {:.4f}, c₂ = {:.4f}: {}\n",
                   notes ? "air outside, always:       " : "media by the inside lists: ", hit->speed_from,
                   hit->speed_to, answer(first));
    }
}

} // namespace

int main() {
    about_the_critical_angle();
    formulas();
    fmt::print("Through a ball of glass\n");
    print_boundaries(trace_ray(open(scenes + "glass_ball.toml"), {{0.5, 0, 5}, {0, 0, -1}}));
    balls();
    fmt::print("Through the prism\n");
    print_boundaries(trace_ray(open(scenes + "prism.toml"), {{-6, 0.1, 0}, {1, 0, 0}}));
    glass_in_water();
}
