// Chapter 3: the mirrored direction, and the notes' recursive algorithm, which ends where core's does.

#include "core/rayscope.hpp"

#include <fmt/format.h>

using namespace rayscope;

namespace {

std::string text(const Vec3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0); // + 0.0: no −0
}
std::string text_of_colour(const Colour& c) { return fmt::format("({:.5f}, {:.5f}, {:.5f})", c.x, c.y, c.z); }

/// Splits d into its part along the unit normal and the rest, and turns the part along the normal.
Vec3d mirrored_direction(const Vec3d& d, const Vec3d& n) { return d - 2 * dot(d, n) * n; }

void mirrored_direction_and_point() {
    const Vec3d eye{0, 0, 3}, d{0, 0.6, -0.8}, n{0, 0, 1}, p = Ray<double>{eye, d}.at(2.5);
    fmt::print("A ray and the plane z = 1\n");
    fmt::print("  hit point       p = {}\n", text(p));
    fmt::print("  along the normal  (d·n) n = {}, the rest {}\n", text(dot(d, n) * n),
               text(d - dot(d, n) * n));
    fmt::print("  mirrored d      d - 2(d·n)n = {}, away from the plane\n", text(mirrored_direction(d, n)));
    fmt::print("  mirrored p      p - 2(p·n)n = {}, into the plane\n\n", text(mirrored_direction(p, n)));
}

struct Found {
    std::uint32_t object;
    Crossing<double> crossing;
};

/// The first crossing ahead. The object that the ray comes from is left out, which is right for planes and balls.
std::optional<Found> nearest(const Workbench& bench, const Ray<double>& ray, int left) {
    std::optional<Found> found;
    const std::vector<Spans<double>> lists = spans(bench, ray);
    for (std::uint32_t object = 0; object < lists.size(); ++object)
        for (const Span<double>& span : lists[object])
            for (const Crossing<double>& c : {span.enter, span.exit})
                if (int(object) != left && c.t > 0 && (!found || c.t < found->crossing.t))
                    found = {object, c};
    return found;
}

/// Ambient, diffuse and specular light, by one light after the other, without shadows.
Colour local_light(const WorldBase& world, const Material& material, const Ray<double>& ray, const Vec3d& p,
                   const Vec3d& n) {
    Colour colour = world.ambient * material.ambient;
    for (const Light& light : world.lights) {
        const Vec3d to_light = normalized(light.position - p);
        const double cosine = dot(n, to_light);
        colour += material.diffuse * light.colour * diffuse_share(cosine);
        colour += material.specular * light.colour *
                  specular_share(cosine, mirror_cosine(to_light, n, ray.direction), material.shininess);
    }
    return colour;
}

/// The notes' algorithm: what a ray brings back, with k mirrored rays left.
Colour shade(const Workbench& bench, const Ray<double>& ray, int k, int left = none) {
    const std::optional<Found> hit = nearest(bench, ray, left);
    if (!hit) return bench.world.background;
    const auto& [t, surface, entering] = hit->crossing;
    const Vec3d p = ray.at(t);
    Vec3d n = bench.world.solids[surface.solid].normal(ray, t, surface.face);
    if (dot(n, ray.direction) > 0) n = -n; // against the ray
    const Material& material = bench.world.material_of(hit->object);
    Colour colour = local_light(bench.world, material, ray, p, n);
    if (k > 0 && largest_component(material.reflection) > 0) {
        const Vec3d l = mirrored_direction(ray.direction, n);
        colour += material.reflection * shade(bench, {p, l}, k - 1, int(hit->object));
    }
    return colour;
}

/// That of the scene's own pixel.
Ray<double> ray_of_the_room(const Workbench& bench) {
    const Camera& camera = bench.scene.camera;
    return EyeRays(camera, camera.width, camera.height).of({600, 235, 0});
}

void thirty_lines_and_core() {
    Workbench bench = open(RAYSCOPE_CHAPTERS "/03_reflection/mirror_room.toml");
    for (Light& light : bench.world.lights) light.shadows = false;
    bench.world.min_weight = 0;
    const Ray<double> ray = ray_of_the_room(bench);
    fmt::print("The colour of one ray in the room of mirrors, by level k\n");
    for (int k = 0; k <= 4; ++k) {
        bench.world.max_depth = k;
        fmt::print("  k = {}  here {}  core {}\n", k, text_of_colour(shade(bench, ray, k)),
                   text_of_colour(trace_ray(bench, ray).colour));
    }
    fmt::print("\n");
}

void levels() {
    fmt::print("Its rays, with the share of the pixel that each carries\n");
    Workbench bench = open(RAYSCOPE_CHAPTERS "/03_reflection/mirror_room.toml");
    bench.world.max_depth = 3;
    const Trace trace = trace_ray(bench, ray_of_the_room(bench));
    for (const TracedRay& ray : trace.rays) {
        if (ray.start().kind == RayKind::shadow) continue;
        const auto* hit = ray.find<BoundaryChosen>();
        fmt::print("  depth {}  weight {:<7.6g} meets {:<13} brings {}\n", ray.start().depth, weight(ray),
                   hit != nullptr ? trace.objects[std::size_t(hit->object)].name : "nothing",
                   text_of_colour(ray.find<RayFinished>()->colour));
    }
    fmt::print("\n");
}

/// Between facing mirrors every ray goes on for ever: what ends it, and what that costs.
void what_ends_it() {
    fmt::print("Two facing mirrors: what ends the recursion, and what is left of the light\n");
    fmt::print("  mirrors  max_depth  min_weight   rays    grey   with blue where it is cut\n");
    const Ray<double> ray{{0, 0, 0}, {1, 0, 0}};
    for (const auto& [mirrors, depth, least] : {std::tuple(0.9, 0, 0.0),
                                                {0.9, 1, 0.0},
                                                {0.9, 3, 0.0},
                                                {0.9, 16, 0.0},
                                                {0.9, 64, 0.0},
                                                {0.9, 250, 0.001},
                                                {1.0, 250, 0.001}}) {
        Workbench bench = open(RAYSCOPE_CHAPTERS "/03_reflection/facing_mirrors.toml");
        for (Material& material : bench.world.materials) material.reflection = Colour{mirrors};
        bench.world.max_depth = depth;
        bench.world.min_weight = least;
        const Trace trace = trace_ray(bench, ray);
        const TracedRay& last = trace.rays.back();
        const Colour invented = trace.colour + weight(last) * mirrors * bench.world.background;
        fmt::print("  {:<7}  {:<9}  {:<10}  {:>5}  {:>7.4f}  ({:.4f}, {:.4f}, {:.4f})\n", mirrors, depth,
                   least, trace.rays.size(), trace.colour.x, invented.x, invented.y, invented.z);
    }
}

} // namespace

int main() {
    mirrored_direction_and_point();
    thirty_lines_and_core();
    levels();
    what_ends_it();
}
