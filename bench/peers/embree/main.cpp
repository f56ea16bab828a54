// How quick are our stages beside Embree? Balls as user geometry, and triangles, one thread, one ray at a time; Mrays/s of
// eye rays, rays into random directions and shadow rays, in one run.

#include "bench/peers/embree/embree_scene.hpp"
#include "bench/support/ratios.hpp"
#include "bench/support/worlds.hpp"
#include "core/bvh/bvh.hpp"
#include "core/octree/octree.hpp"
#include "core/scene/build.hpp"

#include <cstdlib>

namespace {

using namespace rayscope;
using namespace rayscope::bench;

constexpr int edge = 512;

struct Rival {
    std::string name;
    std::function<RaySum(const RaySets&, int kind)> trace; // kind: 0 eye, 1 other, 2 shadow
};

template <typename Stage> Rival stage_rival(const std::string& name, std::shared_ptr<const Stage> stage) {
    return {name, [stage](const RaySets& sets, int kind) {
                static Work<double> work;
                if (kind == 2) return blocked_of(*stage, sets.shadow, work);
                return nearest_of(*stage, kind == 0 ? sets.eye : sets.other, work,
                                  kind == 0 ? RayKind::eye : RayKind::reflected);
            }};
}

Rival embree_rival(std::shared_ptr<const EmbreeScene> scene) {
    return {"embree", [scene](const RaySets& sets, int kind) {
                return kind == 2 ? scene->blocked(sets.shadow)
                                 : scene->nearest(kind == 0 ? sets.eye : sets.other);
            }};
}

constexpr std::array<const char*, 3> kinds{"eye", "other", "shadow"};

std::size_t count_of(const RaySets& sets, int kind) {
    return kind == 0 ? sets.eye.size() : kind == 1 ? sets.other.size() : sets.shadow.size();
}

// Float loses a few rays that pass by an edge: one in a thousand may differ.
bool alike(const std::string& name, const RaySum& a, const RaySum& b, std::size_t rays) {
    const double difference = std::abs(double(a.hits) - double(b.hits));
    if (difference <= 1e-3 * double(rays)) return true;
    std::fprintf(stderr, "%s: %zu hits, expected about %zu\n", name.c_str(), b.hits, a.hits);
    return false;
}

struct Row {
    std::string subject, rival;
    int kind;
    std::size_t rays;
    [[nodiscard]] std::string title() const { return subject + '/' + rival + '/' + kinds[std::size_t(kind)]; }
};

bool add(const std::string& subject, const std::shared_ptr<const RaySets>& sets,
         const std::vector<Rival>& rivals, std::vector<Row>& rows) {
    for (int kind = 0; kind < 3; ++kind) {
        const RaySum expected = rivals.front().trace(*sets, kind);
        for (const Rival& rival : rivals) {
            const Row row{subject, rival.name, kind, count_of(*sets, kind)};
            if (!alike(row.title(), expected, rival.trace(*sets, kind), row.rays)) return false;
            benchmark::RegisterBenchmark(row.title().c_str(), [rival, sets, kind](benchmark::State& state) {
                for (auto _ : state) benchmark::DoNotOptimize(rival.trace(*sets, kind));
            });
            rows.push_back(row);
        }
    }
    return true;
}

// Embree's scene of the same.
using InEmbree = std::function<std::shared_ptr<const EmbreeScene>(const World<double>&)>;

bool add_scene(const std::string& name, const Scene& scene, const InEmbree& embree_of,
               std::vector<Row>& rows) {
    const auto world = std::make_shared<const World<double>>(build(scene));
    Camera camera = scene.camera;
    camera.width = camera.height = edge;
    const auto octree = std::make_shared<const Octree<double>>(*world);
    const auto bvh = std::make_shared<const Bvh<double>>(*world);
    const auto embree = embree_of(*world);
    std::printf("%-14s built in: octree %.3f s, bvh %.3f s, embree %.3f s\n", name.c_str(),
                octree->statistics().build_seconds, bvh->statistics().build_seconds, embree->build_seconds());
    const auto sets =
        std::make_shared<const RaySets>(ray_sets(*world, *bvh, camera, world->lights.front().position));
    static std::vector<std::shared_ptr<const World<double>>> kept; // stages refer to their world
    kept.push_back(world);
    return add(name, sets, {stage_rival("octree", octree), stage_rival("bvh", bvh), embree_rival(embree)},
               rows);
}

std::shared_ptr<const EmbreeScene> balls_in_embree(const World<double>& world) {
    return std::make_shared<const EmbreeScene>(world);
}

// A sphere with bumps, of 2 n² triangles.
Triangles bumpy(std::uint32_t n) {
    Triangles mesh;
    for (std::uint32_t j = 0; j <= n; ++j)
        for (std::uint32_t i = 0; i <= n; ++i) {
            const double theta = std::numbers::pi * (j + 0.001) / (n + 0.002),
                         phi = 2 * std::numbers::pi * i / n,
                         radius = 1 + 0.08 * std::sin(9 * theta) * std::sin(11 * phi);
            mesh.corners.push_back(as<float>(radius * Vec3d{std::sin(theta) * std::cos(phi), std::cos(theta),
                                                            std::sin(theta) * std::sin(phi)}));
        }
    for (std::uint32_t j = 0; j < n; ++j)
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i, c = a + n + 1;
            mesh.indices.push_back({a, a + 1, c + 1});
            mesh.indices.push_back({a, c + 1, c});
        }
    return mesh;
}

Scene scene_before_bumps() {
    Scene scene = cloud(1, 1);
    scene.camera.eye = normalized(Vec3d{0.3, 0.5, 1}) * 3.2;
    scene.generics.clear();
    scene.drawn.clear();
    return scene;
}

void draw(Scene& scene, Generic<double> shape) {
    SceneGeneric& generic = scene.generics.emplace_back();
    generic.shape = std::move(shape);
    generic.material = 0;
    scene.drawn.push_back({false, scene.generics.size() - 1});
}

// Each triangle is an object of its own.
Scene loose(const Triangles& mesh) {
    Scene scene = scene_before_bumps();
    for (const auto& [a, b, c] : mesh.indices)
        draw(scene, Polygon<double>({as<double>(mesh.corners[a]), as<double>(mesh.corners[b]),
                                     as<double>(mesh.corners[c])}));
    return scene;
}

// All are one object.
Scene joined(const Triangles& mesh) {
    MeshData data;
    for (const auto& corner : mesh.corners) data.positions.push_back(as<double>(corner));
    for (const auto& [a, b, c] : mesh.indices) data.triangles.push_back({a, b, c});
    Scene scene = scene_before_bumps();
    draw(scene, Mesh<double>(std::make_shared<TriangleMesh>(std::move(data))));
    return scene;
}

} // namespace

int main(int argc, char** argv) {
    std::vector<Row> rows;
    for (const std::size_t count : {std::size_t(1000), std::size_t(10000), std::size_t(100000)})
        if (!add_scene("balls_" + std::to_string(count), cloud(count, filling_radius(count)), balls_in_embree,
                       rows))
            return 1;
    for (const auto& [name, n] :
         {std::pair("10000", 71U), std::pair("100000", 223U), std::pair("1000000", 707U)}) {
        const Triangles mesh = bumpy(n);
        const auto embree = std::make_shared<const EmbreeScene>(mesh);
        const auto in_embree = [&](const World<double>& /*world*/) { return embree; };
        if (n < 500 && !add_scene(std::string("triangles_") + name, loose(mesh), in_embree, rows)) return 1;
        if (!add_scene(std::string("mesh_") + name, joined(mesh), in_embree, rows)) return 1;
    }
    std::vector<std::string> arguments{argv, argv + argc};
    arguments.insert(arguments.begin() + 1, "--benchmark_min_time=0.1");
    const auto times = run_interleaved(arguments, 5);
    if (!times) return 2;
    std::printf("\n%-32s %9s  %s\n", "Mrays/s", "", "as quick as Embree, times");
    for (const Row& row : rows) {
        if (!times->seconds.contains(row.title())) continue;
        const Row peer{row.subject, "embree", row.kind, row.rays};
        const double seconds = times->quantile(row.title(), 0.5);
        std::printf("%-32s %9.2f", row.title().c_str(), double(row.rays) / seconds / 1e6);
        if (times->seconds.contains(peer.title()))
            std::printf("  %.2f", times->quantile(peer.title(), 0.5) / seconds);
        std::printf("\n");
    }
    return 0;
}
