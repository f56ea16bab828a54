#include "core/generics/polygon.hpp"

#include "core/generics/outline.hpp"
#include "core/math/substituted.hpp"

namespace rayscope {
namespace {

template <Scalar To, Scalar From> std::vector<Vec3<To>> converted(const std::vector<Vec3<From>>& vectors) {
    std::vector<Vec3<To>> result;
    result.reserve(vectors.size());
    for (const Vec3<From>& v : vectors) result.push_back(as<To>(v));
    return result;
}

// A sliver's differences of corners cancel: stable, they are taken in 113 bits.
template <Numbers N, Scalar T = ScalarOf<N>> Vec3<T> normal_of(const std::vector<Vec3<T>>& vertices) {
    if constexpr (is_textbook<N>)
        return normalized(area_vector(vertices));
    else
        return as<T>(normalized(area_vector(converted<Float128>(vertices))));
}

} // namespace

template <Numbers N>
Polygon<N>::Polygon(std::vector<Vec3<T>> vertices, std::vector<Vec3<T>> normals)
    : vertices_(std::move(vertices)), normals_(std::move(normals)), normal_(normal_of<N>(vertices_)) {}

template <Numbers N> auto Polygon<N>::intervals(const Ray<T>& ray, int leaving) const -> Intervals<T> {
    Intervals<T> found;
    if (leaving == 0) return found; // a line meets a plane once
    const T t = plane_crossing(ray);
    if (is_finite(t) && encloses(ray, t)) found.append({t, t, 0, 0});
    return found;
}

template <Numbers N>
auto Polygon<N>::closest(const Ray<T>& ray, const Range<T>& range) const -> std::optional<T> {
    const T t = plane_crossing(ray);
    return range.contains(t) && is_finite(t) && encloses(ray, t) ? std::optional(t) : std::nullopt;
}

// The schoolbook's: the point on the plane, already rounded, against the outline without the normal's largest
// coordinate (Haines 1994). Neighbours compute two points and may both say no.
template <Numbers N> bool Polygon<N>::encloses_in_projection(const Vec3<T>& p) const {
    const Vec3<T> size = absolute(normal_);
    const int dropped = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const int x = (dropped + 1) % 3, y = (dropped + 2) % 3;
    bool inside = false;
    const Vec3<T>* a = &vertices_.back();
    for (const Vec3<T>& b : vertices_) {
        if (((*a)[y] > p[y]) != (b[y] > p[y]) &&
            p[x] < (b[x] - (*a)[x]) * (p[y] - (*a)[y]) / (b[y] - (*a)[y]) + (*a)[x])
            inside = !inside;
        a = &b;
    }
    return inside;
}

// An even-odd count of the edges to one side of the ray.
template <Numbers N> bool Polygon<N>::encloses(const Ray<T>& ray, [[maybe_unused]] T t) const {
    if constexpr (is_textbook<N>) return encloses_in_projection(ray.at(t));
    const OutlineView<T> view(ray);
    bool inside = false;
    auto a = view.corner(vertices_.back());
    for (const Vec3<T>& vertex : vertices_) {
        const auto b = view.corner(vertex);
        if (view.crosses(a, b)) inside = !inside;
        a = b;
    }
    return inside;
}

template <Numbers N> auto Polygon<N>::shading_normal(const Vec3<T>& p) const -> Vec3<T> {
    if (!smooth()) return normal_;
    // In the fan from the first vertex, the triangle that holds p, by its barycentric coordinates.
    for (std::size_t i = 1; i + 1 < vertices_.size(); ++i) {
        const Vec3<T>&a = vertices_[0], &b = vertices_[i], &c = vertices_[i + 1];
        const T whole = dot(normal_, cross(b - a, c - a));
        const T u = dot(normal_, cross(p - a, c - a)) / whole;
        const T v = dot(normal_, cross(b - a, p - a)) / whole;
        const bool last = i + 2 == vertices_.size();
        if (last || (u >= T(0) && v >= T(0) && u + v <= T(1)))
            return (T(1) - u - v) * normals_[0] + u * normals_[i] + v * normals_[i + 1];
    }
    return normal_;
}

template <Numbers N> auto Polygon<N>::bounds() const -> Box<T> {
    Box<T> box;
    for (const Vec3<T>& vertex : vertices_) box.include(vertex);
    return box;
}

template class Polygon<float>;
template class Polygon<double>;
template class Polygon<long double>;
template class Polygon<Float128>;
template class Polygon<Textbook<float>>;
template class Polygon<Textbook<double>>;
template class Polygon<Textbook<long double>>;
template class Polygon<Textbook<Float128>>;
template class Polygon<Substituted>;

} // namespace rayscope
