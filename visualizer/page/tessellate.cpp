#include "visualizer/page/tessellate.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope::page {
namespace {

constexpr double plane_reach = 2.1; // half an edge of a plane's square, in radii of what is shown

Vec3d on_circle(double share) {
    const double turn = 2 * std::numbers::pi * share;
    return {std::cos(turn), std::sin(turn), 0};
}

class Tessellator {
public:
    Tessellator(const Mat4d& matrix, int around, bool clipped, const Ball& shown)
        : matrix_(matrix),
          around_(around),
          clipped_(clipped),
          shown_(shown),
          mirrored_(glm::determinant(Mat3<double>(matrix)) < 0) {}

    Triangles result;

    void operator()(const Sphere<double>&) {
        grid(around_, around_ / 2, true, false, [](double u, double v) {
            const double latitude = (v - 0.5) * std::numbers::pi;
            return on_circle(u) * std::cos(latitude) + Vec3d{0, 0, std::sin(latitude)};
        });
    }
    void operator()(const Torus<double>& torus) {
        grid(around_, around_ / 2, true, true, [&](double u, double v) {
            const Vec3d around_tube = on_circle(v);
            return on_circle(u) * (1 + torus.minor * around_tube.x) +
                   Vec3d{0, 0, torus.minor * around_tube.y};
        });
    }
    void operator()(const Cylinder<double>&) {
        wall(1);
        disk(-1, 1);
        disk(1, 1);
    }
    void operator()(const Cone<double>& cone) {
        wall(cone.top);
        disk(-1, 1);
        if (cone.top > 0) disk(1, cone.top);
    }
    void operator()(const OpenCylinder<double>&) { wall(1); }
    void operator()(const OpenCone<double>& cone) { wall(cone.top); }
    void operator()(const Cube<double>&) {
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0})
                grid(across(), across(), false, false, [&](double u, double v) {
                    Vec3d p;
                    p[axis] = side;
                    p[(axis + 1) % 3] = side * (2 * u - 1);
                    p[(axis + 2) % 3] = 2 * v - 1;
                    return p;
                });
    }
    void operator()(const Plane<double>&) {
        const Vec3d middle = Transform<double>(matrix_).point_to_object(shown_.centre);
        const auto half = [&](int axis) {
            return plane_reach * shown_.radius / length(Vec3d(matrix_[axis]));
        };
        const double du = half(0), dv = half(1);
        grid(across(), across(), false, false, [&](double u, double v) {
            return Vec3d{middle.x + du * (2 * u - 1), middle.y + dv * (2 * v - 1), 0};
        });
    }
    // A fan: of a concave outline it may show more than there is.
    void operator()(const Polygon<double>& polygon) {
        for (const Vec3d& p : polygon.vertices()) add(p);
        for (std::uint32_t i = 2; i < result.corners.size(); ++i) add(0, i - 1, i);
    }
    void operator()(const Mesh<double>& mesh) {
        const MeshData& data = mesh.triangles().data();
        const bool shared = data.smooth();
        if (shared)
            for (const Vec3d& p : data.positions) add(p);
        for (const auto& triangle : data.triangles) {
            if (shared) {
                add(triangle[0], triangle[1], triangle[2]);
                continue;
            }
            const auto first = std::uint32_t(result.corners.size());
            for (const auto corner : triangle) add(data.positions[corner]);
            add(first, first + 1, first + 2);
        }
    }

private:
    [[nodiscard]] int across() const { return clipped_ ? std::max(4, around_ / 2) : 1; }

    /// From radius 1 at z = −1 to `top` at z = 1.
    void wall(double top) {
        grid(around_, clipped_ ? std::max(4, around_ / 2) : 1, true, false,
             [&](double u, double v) { return on_circle(u) * (1 + (top - 1) * v) + Vec3d{0, 0, 2 * v - 1}; });
    }
    void disk(double z, double radius) {
        grid(around_, clipped_ ? std::max(4, around_ / 4) : 1, true, false, [&](double u, double v) {
            return on_circle(u) * (radius * (z < 0 ? v : 1 - v)) + Vec3d{0, 0, z};
        });
    }

    template <typename Face> void grid(int nu, int nv, bool wrap_u, bool wrap_v, const Face& face) {
        const auto first = std::uint32_t(result.corners.size());
        const int columns = wrap_u ? nu : nu + 1, rows = wrap_v ? nv : nv + 1;
        for (int j = 0; j < rows; ++j)
            for (int i = 0; i < columns; ++i) add(face(double(i) / nu, double(j) / nv));
        const auto id = [&](int i, int j) {
            return first + std::uint32_t((j % rows) * columns + i % columns);
        };
        for (int j = 0; j < nv; ++j)
            for (int i = 0; i < nu; ++i) {
                add(id(i, j), id(i + 1, j), id(i + 1, j + 1));
                add(id(i, j), id(i + 1, j + 1), id(i, j + 1));
            }
    }

    void add(const Vec3d& p) { result.corners.emplace_back(matrix_ * glm::dvec4(p, 1)); }
    /// What has no area, at a pole, is left out.
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto& p = result.corners;
        if (length(cross(p[b] - p[a], p[c] - p[a])) == 0) return;
        if (mirrored_) std::swap(b, c);
        result.triangles.push_back({a, b, c});
    }

    Mat4d matrix_;
    int around_;
    bool clipped_;
    const Ball& shown_;
    bool mirrored_;
};

} // namespace

void Triangles::append(const Triangles& other) {
    const auto first = std::uint32_t(corners.size());
    corners.insert(corners.end(), other.corners.begin(), other.corners.end());
    for (const auto& [a, b, c] : other.triangles) triangles.push_back({a + first, b + first, c + first});
}

Triangles tessellate(const Generic<double>& shape, const Mat4d& matrix, int around, bool clipped,
                     const Ball& shown) {
    Tessellator tessellator(matrix, around, clipped, shown);
    std::visit(tessellator, shape);
    return std::move(tessellator.result);
}

} // namespace rayscope::page
