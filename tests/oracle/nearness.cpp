#include "tests/oracle/nearness.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace rayscope::test {
namespace {

using Wide = __float128;
using WideVector = std::array<Wide, 3>;
using WideMatrix = std::array<WideVector, 3>;

WideVector cross(const WideVector& a, const WideVector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Wide dot(const WideVector& a, const WideVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

WideVector column(const Mat4d& matrix, int j) {
    return {Wide(matrix[j][0]), Wide(matrix[j][1]), Wide(matrix[j][2])};
}

// Rows of the inverse of the linear part: reciprocal basis.
WideMatrix inverse(const Mat4d& matrix) {
    const WideVector a = column(matrix, 0), b = column(matrix, 1), c = column(matrix, 2);
    const Wide volume = dot(a, cross(b, c));
    WideMatrix rows{cross(b, c), cross(c, a), cross(a, b)};
    for (WideVector& row : rows)
        for (Wide& element : row) element /= volume;
    return rows;
}

} // namespace

PointInLeaf::PointInLeaf(const CaseLeaf& leaf, const Ray<double>& ray, long double t, double epsilon)
    : shape_(leaf.shape) {
    const WideMatrix rows = inverse(leaf.matrix);
    long double squared = 0;
    for (int i = 0; i < 3; ++i) {
        Wide coordinate = 0, size = 0;
        for (int k = 0; k < 3; ++k) {
            const Wide element = rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
            const Wide from = element * (Wide(ray.origin[k]) - Wide(leaf.matrix[3][k]));
            const Wide along = element * Wide(t) * Wide(ray.direction[k]);
            coordinate += from + along;
            size += (from < 0 ? -from : from) + (along < 0 ? -along : along);
            inverse_[i][k] = static_cast<long double>(element);
        }
        point_[i] = static_cast<long double>(coordinate);
        squared += static_cast<long double>(size) * static_cast<long double>(size);
    }
    reach_ = 64.0L * static_cast<long double>(epsilon) * std::sqrt(squared);
}

std::vector<PointInLeaf::Face> PointInLeaf::faces() const {
    const long double x = point_.x, y = point_.y, z = point_.z;
    const long double around = std::hypot(x, y);
    const Vector outwards = around > 0 ? Vector{x / around, y / around, 0} : Vector{1, 0, 0};
    const Vector up{0, 0, 1};
    if (std::holds_alternative<Sphere<double>>(shape_)) return {{"side", std::hypot(x, y, z) - 1, point_}};
    if (std::holds_alternative<Plane<double>>(shape_)) return {{"plane", z, up}};
    if (std::holds_alternative<Cylinder<double>>(shape_))
        return {{"side", around - 1, outwards}, {"cap+", z - 1, up}, {"cap-", -z - 1, -up}};
    if (std::holds_alternative<Cone<double>>(shape_))
        return {{"side", (around - (1 - z) / 2) / std::sqrt(1.25L), outwards + 0.5L * up},
                {"apex", z - 1, up},
                {"cap-", -z - 1, -up}};
    if (std::holds_alternative<Cube<double>>(shape_))
        return {{"+x", x - 1, {1, 0, 0}},   {"-x", -x - 1, {-1, 0, 0}}, {"+y", y - 1, {0, 1, 0}},
                {"-y", -y - 1, {0, -1, 0}}, {"+z", z - 1, up},          {"-z", -z - 1, -up}};
    if (const auto* torus = std::get_if<Torus<double>>(&shape_))
        return {{"torus", std::hypot(around - 1, z) - static_cast<long double>(torus->minor),
                 (around - 1) * outwards + z * up}};
    throw std::logic_error("the oracle has no such shape");
}

PointInLeaf::Face PointInLeaf::face(const std::string& name) const {
    for (const Face& candidate : faces())
        if (candidate.name == name) return candidate;
    throw std::logic_error("the leaf has no face " + name);
}

bool PointInLeaf::is_near_surface() const {
    const auto all = faces();
    return std::abs(std::ranges::max(all, {}, &Face::distance).distance) <= reach_;
}

bool PointInLeaf::is_near(const std::string& name) const { return std::abs(face(name).distance) <= reach_; }

Vec3d PointInLeaf::normal(const std::string& name) const {
    const Vector n = face(name).normal;
    Vector world{0};
    for (int i = 0; i < 3; ++i) world += n[i] * inverse_[i];
    const long double size = std::hypot(world.x, world.y, world.z);
    return {static_cast<double>(world.x / size), static_cast<double>(world.y / size),
            static_cast<double>(world.z / size)};
}

} // namespace rayscope::test
