// Chapter 6: one ray's way through the octree, what it costs as a scene grows, and the trap at a cell's face.

#include "core/rayscope.hpp"

#include <fmt/format.h>

using namespace rayscope;

namespace {

/// The cells that one recorded ray looked into, in the order of its way.
void print_way(const Trace& trace, std::size_t index) {
    const TracedRay& ray = trace.rays[index];
    const PlaceEntered* cell = nullptr;
    for (const Event& event : ray.events) {
        if (const auto* entered = std::get_if<PlaceEntered>(&event))
            cell = entered->kind == PlaceKind::cell ? entered : nullptr;
        const auto* left = std::get_if<PlaceLeft>(&event);
        if (left == nullptr || cell == nullptr) continue;
        fmt::print(
            "  cell {:<4} level {}  edge {:.4f}  t {:>7.4f} to {:>7.4f}  holds {}, tested {}, spared {}\n",
            cell->place, cell->level, cell->high.x - cell->low.x, cell->t_in, cell->t_out, cell->held,
            left->tested, left->spared);
    }
    const auto* end = ray.find<SearchEnded>();
    const auto* hit = ray.find<BoundaryChosen>();
    fmt::print("  {}: {} objects tested, {} spared\n\n",
               hit != nullptr
                   ? fmt::format("hit {} at t = {:.4f}", trace.objects[std::size_t(hit->object)].name,
                                 ray.find<ObjectAccepted>() != nullptr ? *end_of(ray) : 0)
                   : "no hit",
               end->tested, end->spared);
}

void one_way() {
    const Workbench chain = open(RAYSCOPE_CHAPTERS "/01_generics/torus_chain.toml");
    const auto stages = make_stages(chain, stage_choice("octree"));
    const Trace trace = trace_pixel(chain, *stages, 330, 190);
    fmt::print("The eye's ray through pixel (330, 190) of torus_chain\n");
    print_way(trace, 0);
    for (std::size_t i = 1; i < trace.rays.size(); ++i)
        if (trace.rays[i].start().kind == RayKind::reflected) {
            fmt::print("The ray that it sends on, mirrored\n");
            print_way(trace, i);
            return;
        }
}

/// n³ balls in the cube [−1, 1]³, each with a tenth of its cell's edge for a radius.
Scene cloud(int n) {
    Scene scene;
    scene.materials.emplace_back();
    for (int i = 0; i < n * n * n; ++i) {
        SceneGeneric ball;
        ball.name = fmt::format("ball{}", i);
        ball.shape = Sphere<double>{};
        ball.material = 0;
        const double cell = 2.0 / n;
        const Vec3d place = Vec3d(i % n, i / n % n, i / n / n) + Vec3d{0.5};
        for (int axis = 0; axis < 3; ++axis) ball.matrix[axis][axis] = 0.1 * cell;
        ball.matrix[3] = {place * cell - Vec3d{1}, 1};
        scene.generics.push_back(std::move(ball));
        scene.drawn.push_back({false, std::size_t(i)});
    }
    scene.camera.eye = {2.1, 1.7, 4.3};
    return scene;
}

void growth() {
    fmt::print("Balls in a cube: work for each eye ray\n");
    fmt::print("  balls   scan: tests   octree: tests, nodes and cells   bvh: tests, nodes and leaves\n");
    for (const int n : {2, 4, 8, 16}) {
        const Workbench bench = make_workbench(cloud(n));
        fmt::print("  {:<6}", n * n * n);
        for (const char* stage : {"scan", "octree", "bvh"}) {
            RenderOptions options;
            options.width = options.height = 48;
            options.stage = stage_choice(stage);
            const Counters done = render(bench, options).statistics.counters;
            const double rays = double(done.rays[0]);
            if (options.stage->eye == StageKind::scan)
                fmt::print("  {:>11.1f}", double(done.objects) / rays);
            else
                fmt::print("   {:>15.2f}, {:>11.2f}", double(done.objects) / rays,
                           double(done.nodes + done.cells) / rays);
        }
        fmt::print("\n");
    }
    fmt::print("\n");
}

/// The unit ball about (1, 0, 0) touches the face x = 0 of the cells beside it, and is listed only beyond it.
void touching_a_face() {
    int hits = 0, before = 0;
    for (int i = -50; i <= 50; ++i)
        for (int j = -50; j <= 50; ++j) {
            const Vec3d origin{-3, 0.02 * i, 0.02 * j};
            const Ray<double> ray{origin, -origin}; // at the point where ball and face touch: t = 1
            const Ray<double> moved{ray.origin - Vec3d{1, 0, 0}, ray.direction};
            for (const Interval<double>& inside : Sphere<double>{}.intervals(moved)) {
                ++hits;
                before += ray.at(inside.enter).x < 0 ? 1 : 0;
            }
        }
    fmt::print("Rays at the point where a ball touches a cell's face\n");
    fmt::print("  {} hits; {} of the computed points lie before the face,\n  in a cell that does not list "
               "the ball\n",
               hits, before);
}

} // namespace

int main() {
    one_way();
    growth();
    touching_a_face();
}
