#include "core/povray/shapes.hpp"

#include "core/mesh/triangulate.hpp"
#include "core/povray/differences.hpp"
#include "core/povray/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace rayscope::povray {
namespace {

class ShapeText {
public:
    ShapeText(const Mat4d& matrix, const std::string& modifiers) : matrix_(matrix), modifiers_(modifiers) {}

    std::string operator()(const Sphere<double>& sphere) const {
        const double scale = similarity_scale<double>(matrix_);
        if (!(scale > 0)) return moved("sphere", "0, " + number(sphere.radius));
        return whole("sphere", vector(Vec3d{matrix_[3]}) + ", " + number(scale * sphere.radius));
    }
    std::string operator()(const Plane<double>&) const { return moved("plane", "z, 0"); }
    std::string operator()(const Cylinder<double>&) const { return moved("cylinder", "-z, z, 1"); }
    std::string operator()(const OpenCylinder<double>&) const { return moved("cylinder", "-z, z, 1 open"); }
    std::string operator()(const Cone<double>& cone) const {
        return moved("cone", "-z, 1, z, " + number(cone.top));
    }
    std::string operator()(const OpenCone<double>& cone) const {
        return moved("cone", "-z, 1, z, " + number(cone.top) + " open");
    }
    std::string operator()(const Cube<double>&) const { return moved("box", "-1, 1"); }
    // POV-Ray's lies about the y axis. Without sturm its quartic loses thin and distant rings.
    std::string operator()(const Torus<double>& torus) const {
        return moved("torus", "1, " + number(torus.minor) + " sturm rotate 90*x");
    }
    // Corners are moved here: POV-Ray takes a small polygon that a matrix would enlarge for none.
    std::string operator()(const Polygon<double>& polygon) const {
        if (polygon.smooth()) return smooth(polygon);
        if (meets_itself(polygon)) return cut(polygon);
        std::string corners;
        for (const Vec3d& v : polygon.vertices()) corners += (corners.empty() ? "" : ", ") + corner(v);
        if (polygon.vertices().size() == 3) return whole("triangle", corners);
        // POV-Ray's outline ends where it began.
        return whole("polygon", fmt::format("{}, {}, {}", polygon.vertices().size() + 1, corners,
                                            corner(polygon.vertices().front())));
    }

    // A direction makes POV-Ray know an inside: it counts crossings along it.
    std::string operator()(const Mesh<double>& mesh) const {
        const MeshData& data = mesh.triangles().data();
        const Transform<double> transform(matrix_);
        // POV-Ray's normal of a flat triangle is −(b − a) × (c − a).
        const bool mirrors = glm::determinant(glm::dmat3(matrix_)) < 0;
        const std::array<std::size_t, 3> order = mirrors || data.smooth()
                                                     ? std::array<std::size_t, 3>{0, 1, 2}
                                                     : std::array<std::size_t, 3>{0, 2, 1};
        std::string triangles;
        for (std::size_t i = 0; i < data.triangles.size(); ++i) {
            std::string corners;
            for (const std::size_t k : order) {
                corners += (k == 0 ? "" : ", ") + corner(data.positions[data.triangles[i][k]]);
                if (data.smooth())
                    corners +=
                        ", " +
                        vector(transform.normal_to_world(as<double>(data.normals[data.normals_of(i)[k]])));
            }
            triangles +=
                fmt::format("{} {{ {} }}\n", data.smooth() ? "smooth_triangle" : "triangle", corners);
        }
        return whole("mesh", "\n" + triangles + (mesh.solid ? "inside_vector z" : ""));
    }

private:
    [[nodiscard]] std::string whole(std::string_view kind, const std::string& what) const {
        return fmt::format("{} {{ {}{}{} }}\n", kind, what, modifiers_.empty() ? "" : " ", modifiers_);
    }
    [[nodiscard]] std::string moved(std::string_view kind, const std::string& what) const {
        return whole(kind, matrix_ == Mat4d{1} ? what : what + " " + povray::matrix(matrix_));
    }

    // Where an outline comes back to a corner, POV-Ray lets another one begin.
    [[nodiscard]] static bool meets_itself(const Polygon<double>& polygon) {
        std::vector<Vec3d> corners = polygon.vertices();
        const auto before = [](const Vec3d& a, const Vec3d& b) {
            return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
        };
        std::ranges::sort(corners, before);
        return std::ranges::adjacent_find(corners) != corners.end();
    }
    [[nodiscard]] std::string cut(const Polygon<double>& polygon) const {
        const auto& corners = polygon.vertices();
        std::string triangles;
        Triangulation triangulation;
        for (const MeshData::Corners& t : triangulation.of(corners))
            triangles += fmt::format("\ntriangle {{ {}, {}, {} }}", corner(corners[t[0]]),
                                     corner(corners[t[1]]), corner(corners[t[2]]));
        return whole("mesh", triangles + "\n");
    }

    // The same fan of triangles in which our own normals are interpolated. In a mesh, since alone POV-Ray refuses those
    // whose corners are turned to different sides.
    [[nodiscard]] std::string smooth(const Polygon<double>& polygon) const {
        const Transform<double> transform(matrix_);
        const auto pair = [&](std::size_t i) {
            return corner(polygon.vertices()[i]) + ", " +
                   vector(transform.normal_to_world(polygon.normals()[i]));
        };
        std::string triangles;
        for (std::size_t i = 1; i + 1 < polygon.vertices().size(); ++i)
            triangles += fmt::format("{}smooth_triangle {{ {}, {}, {} }}", i > 1 ? " " : "", pair(0), pair(i),
                                     pair(i + 1));
        return whole("mesh", triangles);
    }

    [[nodiscard]] std::string corner(const Vec3d& p) const { return vector(moved_point(matrix_, p)); }

    const Mat4d& matrix_;
    const std::string& modifiers_;
};

} // namespace

std::string shape(const Generic<double>& generic, const Mat4d& matrix, const std::string& modifiers) {
    return std::visit(ShapeText(matrix, modifiers), generic);
}

} // namespace rayscope::povray
