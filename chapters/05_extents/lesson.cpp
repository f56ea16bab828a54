// Chapter 5: when an extent pays, what each stage saves, and the trap of projected corners.

#include "core/rayscope.hpp"

#include <fmt/format.h>

#include <numbers>

using namespace rayscope;

namespace {

const std::string scenes = RAYSCOPE_CHAPTERS;

/// With an extent every ray pays for the box, and those that hit it for the object as well.
double cost_with_extent(double box, double object, double share_that_hits) {
    return box + share_that_hits * object;
}

void does_it_pay() {
    fmt::print("What a test costs, by the share of rays that hit the box; the object alone costs 1\n");
    fmt::print("  box costs    5 % hit  25 % hit  50 % hit  75 % hit\n");
    for (const double box : {0.1, 0.5, 0.9, 1.5}) {
        fmt::print("  {:<11}", box);
        for (const double share : {0.05, 0.25, 0.5, 0.75}) {
            const double cost = cost_with_extent(box, 1, share);
            fmt::print("  {:>3} {:.2f}", cost < 1 ? "yes" : "no", cost);
        }
        fmt::print("\n");
    }
    fmt::print("\n");
}

/// Rays from one side, evenly over the cube's face; and, from all directions, the ratio of the surfaces (Cauchy).
void how_well_it_fits() {
    int hits = 0;
    constexpr int n = 200;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const Ray<double> ray{{(i + 0.5) / (n / 2) - 1, (j + 0.5) / (n / 2) - 1, 5}, {0, 0, -1}};
            hits += Sphere<double>{}.intervals(ray).count;
        }
    fmt::print("Of the rays that hit the cube around a sphere, the sphere is hit by\n");
    fmt::print("  {:.3f} straight on; π / 4 = {:.3f}\n", double(hits) / (n * n), std::numbers::pi / 4);
    fmt::print("  {:.3f} from all directions: 4π / 24\n", 4 * std::numbers::pi / 24);
    const Ray<double> beside{{1.1, 0, 5}, {0, 0, -1}};
    fmt::print("  a ray at x = 1.1: the cube {}, a torus of minor radius 0.25 {}\n\n",
               Cube<double>{}.intervals(beside).count == 1 ? "hit" : "missed",
               Torus<double>{}.intervals(beside).count == 1 ? "hit" : "missed");
}

void by_stage(const char* name, std::initializer_list<const char*> stages) {
    const Workbench bench = open(fmt::format("{}/05_extents/{}.toml", scenes, name));
    fmt::print("{}, 160 × 120 pixels, by stage\n", name);
    fmt::print("  stage        rays  generics tested  boxes tested  nodes and cells  all per ray\n");
    for (const char* stage : stages) {
        RenderOptions options;
        options.width = 160;
        options.height = 120;
        options.stage = stage_choice(stage);
        const Counters done = render(bench, options).statistics.counters;
        std::uint64_t rays = 0, generics = 0;
        for (const std::uint64_t count : done.rays) rays += count;
        for (const std::uint64_t count : done.tests) generics += count;
        const std::uint64_t places = done.nodes + done.cells;
        fmt::print("  {:<10} {:>6}  {:>15}  {:>12}  {:>15}  {:>11.2f}\n", stage, rays, generics, done.boxes,
                   places, double(generics + done.boxes + places) / double(rays));
    }
    fmt::print("\n");
}

void rectangles() {
    const Workbench bench = open(scenes + "/02_csg/glass_bowl.toml");
    const ScreenExtents screen = screen_extents(bench);
    fmt::print("Rectangles on the screen of the glass bowl, {} × {} pixels\n", screen.width, screen.height);
    for (const auto& r : screen.rectangles)
        fmt::print("  {:<7} x {:.1f} to {:.1f}, y {:.1f} to {:.1f}, no nearer than {:.4f}\n", r.name, r.left,
                   r.right, r.top, r.bottom, r.nearest);
    for (const std::string& name : screen.apart) fmt::print("  {:<7} has no end, and no rectangle\n", name);
    fmt::print("\n");
}

/// Seen from the origin along −z: slopes x / −z and y / −z.
void near_plane_trap() {
    fmt::print("A box from (1, 1, -4) to (2, 2, 1), seen from the origin along -z\n");
    double least = infinity<double>, most = -infinity<double>, clipped = -infinity<double>;
    for (const double x : {1.0, 2.0})
        for (const double z : {-4.0, 1.0}) {
            const double slope = x / -z;
            fmt::print("  edge x = {}, z = {:>2}: slope {:>5.2f}{}\n", x, z, slope,
                       z > 0 ? ", behind the eye, on the wrong side" : "");
            least = minimum(least, slope);
            most = maximum(most, slope);
            clipped = maximum(clipped, x / 0.1); // where the edge meets the near plane z = −0.1
        }
    fmt::print("  rectangle of all corners: {:.2f} to {:.2f}\n", least, most);
    fmt::print("  but the box's point (1.5, 1.5, -1) is seen at {:.2f}\n", 1.5);
    fmt::print("  clipped at z = -0.1 first: {:.2f} to {:.2f}\n", 0.25, clipped);
}

} // namespace

int main() {
    does_it_pay();
    how_well_it_fits();
    by_stage("crowd", {"scan", "extents", "projective", "light", "octree"});
    by_stage("abacus", {"scan", "extents"});
    rectangles();
    near_plane_trap();
}
