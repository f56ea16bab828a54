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

// In the processor's own 64 bits, a thirtieth of the work, where nothing cancels: each product of two edges is off by 2⁻⁶²
// of itself, so that what they add up to is known to 2⁻⁵⁶.
std::optional<Vec3<long double>> clear_normal(const std::vector<Vec3<long double>>& vertices) {
    long double edges = 0;
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        edges += length(vertices[i] - vertices[0]) * length(vertices[i + 1] - vertices[0]);
    const Vec3<long double> area = area_vector(vertices);
    if (!(length(area) * 64 > edges)) return std::nullopt;
    return normalized(area);
}

// A sliver's differences of corners cancel: stable, they are taken in 113 bits.
template <Numbers N, Scalar T = ScalarOf<N>> Vec3<T> normal_of(const std::vector<Vec3<T>>& vertices) {
    if constexpr (is_textbook<N>) return normalized(area_vector(vertices));
    if constexpr (limits::digits<T> <= limits::digits<double>)
        if (const auto normal = clear_normal(converted<long double>(vertices))) return as<T>(*normal);
    return as<T>(normalized(area_vector(converted<Float128>(vertices))));
}

} // namespace

template <Numbers N>
Polygon<N>::Polygon(std::vector<Vec3<T>> vertices, std::vector<Vec3<T>> normals)
    : vertices_(std::move(vertices)), normals_(std::move(normals)), normal_(normal_of<N>(vertices_)) {
    if constexpr (!is_textbook<N>) discs_ = discs();
}

template <Numbers N> auto Polygon<N>::discs() const -> Discs {
    Discs discs;
    for (const Vec3<T>& vertex : vertices_) {
        discs.middle += vertex / T(vertices_.size());
        discs.size = maximum(discs.size, largest_component(absolute(vertex)));
    }
    discs.around = T(0);
    discs.within = encloses_in_projection(discs.middle) ? infinity<T> : T(0);
    const Vec3<T>* a = &vertices_.back();
    for (const Vec3<T>& b : vertices_) {
        // No edge's line comes nearer than this.
        const Vec3<T> edge = b - *a;
        const T distance = magnitude(dot(normal_, cross(edge, discs.middle - *a))) / length(edge);
        discs.within = distance < discs.within ? distance : discs.within;
        discs.around = maximum(discs.around, length(b - discs.middle));
        a = &b;
    }
    if (!is_safe_square(discs.within * discs.within)) discs.within = T(0); // then they tell nothing
    return discs;
}

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

// The point on the plane is off by the rounding of its coordinates, and along the ray by that of t, which grows as the ray
// comes to lie in the plane. Where both are a small part of the inner disc, only what is near its edge need be asked more.
template <Numbers N> auto Polygon<N>::encloses_clearly(const Ray<T>& ray, T t) const -> std::optional<bool> {
    constexpr T part = limits::power_of_half<T>(8);
    const T step = largest_component(absolute(ray.direction));
    const T far = largest_component(absolute(ray.origin)) + magnitude(t) * step + discs_.size;
    if (!(T(64) * epsilon<T> * far * step < part * discs_.within * magnitude(dot(normal_, ray.direction))))
        return std::nullopt;
    const Vec3<T> off = ray.at(t) - discs_.middle;
    const T squared = dot(off, off), within = (T(1) - T(2) * part) * discs_.within,
            around = discs_.around + T(2) * part * discs_.within;
    if (squared < within * within) return true;
    if (squared > around * around) return false;
    return std::nullopt;
}

// An even-odd count of the edges to one side of the ray.
template <Numbers N> bool Polygon<N>::encloses(const Ray<T>& ray, T t) const {
    if constexpr (is_textbook<N>) return encloses_in_projection(ray.at(t));
    if (const auto clearly = encloses_clearly(ray, t)) return *clearly;
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
