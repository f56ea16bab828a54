#include "core/mesh/triangulate.hpp"

#include <algorithm>
#include <numeric>

namespace rayscope {
namespace {

using Flat = std::array<double, 2>;

// Twice the area of a triangle, positive where it runs counter-clockwise.
double doubled_area(const Flat& a, const Flat& b, const Flat& c) {
    return difference_of_products(b[0] - a[0], c[1] - a[1], b[1] - a[1], c[0] - a[0]);
}

Vec3d newell_normal(std::span<const Vec3d> corners) {
    Vec3d sum{0};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += cross(corners[i] - corners[0], corners[i + 1] - corners[0]);
    return sum;
}

} // namespace

bool is_fan(std::span<const Vec3d> corners) {
    const Vec3d normal = newell_normal(corners);
    double last = 0;
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
        last = dot(normal, cross(corners[i] - corners[0], corners[i + 1] - corners[0]));
        if (!(last >= 0)) return false;
    }
    return last > 0;
}

std::span<const MeshData::Corners> Triangulation::of(std::span<const Vec3d> corners) {
    triangles_.clear();
    if (corners.size() == 3) {
        triangles_.push_back({0, 1, 2});
        return triangles_;
    }
    const Vec3d normal = newell_normal(corners), size = absolute(normal);
    const int z = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    const bool from_below = normal[z] < 0;
    flat_.clear();
    for (const Vec3d& p : corners) flat_.push_back(from_below ? Flat{p[y], p[x]} : Flat{p[x], p[y]});
    left_.resize(corners.size());
    std::iota(left_.begin(), left_.end(), 0U);
    for (std::size_t at = 0, refused = 0; left_.size() > 3;) {
        const std::size_t n = left_.size();
        at %= n;
        // An outline that crosses itself may have no ear: then any corner goes.
        if (refused < n && !is_ear(at)) {
            ++at;
            ++refused;
            continue;
        }
        triangles_.push_back({left_[(at + n - 1) % n], left_[at], left_[(at + 1) % n]});
        left_.erase(left_.begin() + std::ptrdiff_t(at));
        refused = 0;
    }
    triangles_.push_back({left_[0], left_[1], left_[2]});
    return triangles_;
}

// A corner that bends to the left, with no other within its triangle; or one whose triangle has no inside.
bool Triangulation::is_ear(std::size_t at) const {
    const std::size_t n = left_.size();
    const std::uint32_t before = left_[(at + n - 1) % n], here = left_[at], after = left_[(at + 1) % n];
    const Flat &a = flat_[before], &b = flat_[here], &c = flat_[after];
    if (a == b || b == c || a == c) return true; // a corner twice, or a spike: nothing lies within
    if (!(doubled_area(a, b, c) > 0)) return false;
    return std::none_of(left_.begin(), left_.end(), [&](std::uint32_t other) {
        const Flat& p = flat_[other];
        if (p == a || p == b || p == c) return false;
        return doubled_area(a, b, p) >= 0 && doubled_area(b, c, p) >= 0 && doubled_area(c, a, p) >= 0;
    });
}

} // namespace rayscope
