// Chapter 1: generics, the matrix that places them, and the ray that is moved instead.

#include "core/rayscope.hpp"

#include <fmt/format.h>

using namespace rayscope;

namespace {

std::string text(const Vec3d& v) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", v.x + 0.0, v.y + 0.0, v.z + 0.0); // + 0.0: no −0
}

/// To six decimals: what rounding leaves of a zero is zero.
double rounded(double x) { return std::round(x * 1e6) / 1e6 + 0.0; }

/// Twice as long along x, then moved to x = 4: `scale` acts first, so it stands on the right.
Mat4d egg_matrix() {
    Mat4d scale{1}, translation{1};
    scale[0][0] = 2;
    translation[3] = {4, 0, 0, 1};
    return translation * scale;
}

Vec3d moved_point(const Mat4d& matrix, const Vec3d& p) { return matrix * glm::dvec4(p, 1); }
Vec3d moved_direction(const Mat4d& matrix, const Vec3d& v) { return matrix * glm::dvec4(v, 0); }

const Ray<double> ray{{0, 0.6, 0}, {1, 0, 0}};

void two_spaces() {
    const Mat4d matrix = egg_matrix();
    const Ray<double> moved = Transform<double>(matrix).to_object(ray);
    fmt::print("One ray in two spaces\n");
    fmt::print("  in the world     origin {}, direction {}\n", text(ray.origin), text(ray.direction));
    fmt::print("  in object space  origin {}, direction {}\n", text(moved.origin), text(moved.direction));
    const Interval<double> inside = *Sphere<double>{}.intervals(moved).begin();
    for (const double t : {inside.enter, inside.exit})
        fmt::print(
            "  t = {:.6g}: a point {} of the unit sphere\n           moved by M {}, on the world's ray {}\n",
            t, text(moved.at(t)), text(moved_point(matrix, moved.at(t))), text(ray.at(t)));
    fmt::print("\n");
}

void renormalized() {
    const Mat4d matrix = egg_matrix();
    Ray<double> moved = Transform<double>(matrix).to_object(ray);
    moved.direction = normalized(moved.direction);
    const double t = Sphere<double>{}.intervals(moved).begin()->enter;
    const Vec3d p = ray.at(t);
    const Vec3d q = Transform<double>(matrix).point_to_object(p);
    fmt::print("The same with the direction made unit again\n");
    fmt::print("  direction {}, t = {:.6g}\n", text(moved.direction), t);
    fmt::print("  on the world's ray {}, in object space {:.6g} from the centre, not 1\n\n", text(p),
               length(q));
}

void normals() {
    const Mat4d matrix = egg_matrix();
    const Vec3d n{-0.8, 0.6, 0}, tangent{0.6, 0.8, 0}; // at the point (−0.8, 0.6, 0) of the unit sphere
    const Vec3d surface = moved_direction(matrix, tangent);
    const Vec3d wrong = moved_direction(matrix, n), right = Transform<double>(matrix).normal_to_world(n);
    fmt::print("Two ways to move a normal\n");
    fmt::print("  tangent  M v   = {}\n", text(surface));
    fmt::print("  wrong    M n   = {}, times the tangent: {:.6g}\n", text(wrong),
               rounded(dot(wrong, surface)));
    fmt::print("  right    M⁻ᵀ n = {}, times the tangent: {:.6g}\n", text(right),
               rounded(dot(right, surface)));
    Mat4d mirror{1};
    mirror[0][0] = -1;
    fmt::print("  mirrored in x  = {}: still outward\n\n",
               text(Transform<double>(mirror).normal_to_world(n)));
}

std::string list_of(const auto& shape, const Ray<double>& line) {
    std::string list;
    for (const Interval<double>& inside : shape.intervals(line))
        list += fmt::format(" ({:.6g}, {:.6g})", inside.enter, inside.exit);
    return list.empty() ? " never inside" : list;
}

void all_generics() {
    const Ray<double> line{{-4, 0, 1}, {2, 0, -0.5}};
    fmt::print("All generics on one line, origin {}, direction {}\n", text(line.origin),
               text(line.direction));
    fmt::print("  sphere  {}\n", list_of(Sphere<double>{}, line));
    fmt::print("  plane   {}\n", list_of(Plane<double>{}, line));
    fmt::print("  cylinder{}\n", list_of(Cylinder<double>{}, line));
    fmt::print("  cone    {}\n", list_of(Cone<double>{}, line));
    fmt::print("  cube    {}\n", list_of(Cube<double>{}, line));
    fmt::print("  torus   {}\n\n", list_of(Torus<double>{}, line));
}

void hit_lists() {
    const Workbench bench = open(RAYSCOPE_CHAPTERS "/01_generics/torus_chain.toml");
    const Ray<double> line{{-5, 0, 0}, {1, 0, 0}};
    const std::vector<Spans<double>> lists = spans(bench, line);
    fmt::print("The chain of rings, along its middle\n");
    for (std::size_t object = 0; object < lists.size(); ++object) {
        std::string list;
        for (const Span<double>& inside : lists[object])
            list += fmt::format(" ({:.6g}, {:.6g})", inside.enter.t, inside.exit.t);
        fmt::print("  {:<7}{}\n", object_title(bench.scene, bench.scene.drawn[object]),
                   list.empty() ? " never inside" : list);
    }
}

} // namespace

int main() {
    two_spaces();
    renormalized();
    normals();
    all_generics();
    hit_lists();
}
