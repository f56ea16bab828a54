#include "core/generics/mesh.hpp"

#include "core/generics/triangle_ray.hpp"
#include "core/math/substituted.hpp"

#include <algorithm>

namespace rayscope {

template <Numbers N> void Mesh<N>::all(const Ray<T>& ray, std::vector<MeshCrossing<T>>& out) const {
    out.clear();
    const TriangleRay<N> view(ray);
    const auto test = [&](std::uint32_t triangle) {
        const Corners t = corners(triangle);
        if (const auto hit = view.hit(t.a, t.b, t.c)) out.push_back({hit->t, triangle, hit->entering});
    };
    const auto endless = [] { return infinity<double>; };
    triangles_->along(as<double>(ray), kernel_unit, endless, test);
    triangles_->along(as<double>(Ray<T>{ray.origin, -ray.direction}), kernel_unit, endless, test);
    // By t; at the same t what enters comes first, so that the seam of two parts that touch is no boundary.
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
        if (a.t != b.t) return a.t < b.t;
        if (a.entering != b.entering) return a.entering;
        return a.triangle < b.triangle;
    });
    const auto same = [](const auto& a, const auto& b) { return a.triangle == b.triangle; };
    out.erase(std::unique(out.begin(), out.end(), same), out.end()); // both half lines may find it
}

// Keeps the crossings between inside and outside. At a silhouette rounding may put the way out before the way in: the line
// is then never inside.
template <Numbers N> void Mesh<N>::settle(std::vector<MeshCrossing<T>>& list) const {
    if (!solid) return;
    std::size_t kept = 0;
    int turns = 0;
    for (const MeshCrossing<T>& crossing : list) {
        const bool before = turns > 0;
        turns += crossing.entering ? 1 : -1;
        if (before == (turns > 0)) continue;
        if (before && list[kept - 1].t == crossing.t)
            --kept; // without length
        else
            list[kept++] = crossing;
    }
    // As many lead in as out, but the schoolbook's test may lose one at an edge.
    list.resize(kept - kept % 2);
}

template <Numbers N>
void Mesh<N>::crossings(const Ray<T>& ray, int leaving, std::vector<MeshCrossing<T>>& out) const {
    all(ray, out);
    if (leaving != no_face) {
        const auto start = std::find_if(out.begin(), out.end(),
                                        [&](const auto& c) { return c.triangle == std::uint32_t(leaving); });
        if (start != out.end()) {
            MeshCrossing<T> at_start = *start;
            at_start.t = T(0);
            out.erase(start);
            if (solid) // a surface is met once
                out.insert(std::find_if(out.begin(), out.end(), [](const auto& c) { return c.t > T(0); }),
                           at_start);
        }
    }
    settle(out);
}

// By more than a crossing's t may be off.
template <Numbers N> bool Mesh<N>::is_outside_of_bounds(const Vec3<T>& p) const {
    const Box<T> box = bounds();
    const Vec3<T> off = maximum_of(box.low - p, p - box.high);
    const Vec3<T> size = maximum_of(maximum_of(absolute(box.low), absolute(box.high)), absolute(p));
    return largest_component(off) > T(64) * epsilon<T> * largest_component(size);
}

/// The first of those that count, and whether all that count at its t lead in.
template <Numbers N>
template <typename Counts>
auto Mesh<N>::nearest(const Ray<T>& ray, const Range<T>& range, const Counts& counts, bool& leads_in) const
    -> std::optional<MeshCrossing<T>> {
    const TriangleRay<N> view(ray);
    std::optional<MeshCrossing<T>> first;
    triangles_->along(
        as<double>(ray), kernel_unit, [&] { return double(first ? first->t : range.max); },
        [&](std::uint32_t triangle) {
            const Corners t = corners(triangle);
            const auto hit = view.hit(t.a, t.b, t.c);
            if (!hit || !range.contains(hit->t) || (first && hit->t > first->t)) return;
            const MeshCrossing<T> crossing{hit->t, triangle, hit->entering};
            if (!counts(crossing)) return;
            if (!first || hit->t < first->t) {
                first = crossing;
                leads_in = hit->entering;
                return;
            }
            leads_in = leads_in && hit->entering;
            const bool earlier =
                hit->entering == first->entering ? triangle < first->triangle : hit->entering;
            if (earlier) first = crossing;
        });
    return first;
}

template <Numbers N>
auto Mesh<N>::closest(const Ray<T>& ray, const Range<T>& range) const -> std::optional<MeshCrossing<T>> {
    bool leads_in = false;
    const auto first = nearest(ray, range, [](const auto&) { return true; }, leads_in);
    // From outside the first crossing leads in. Elsewhere it may lie within, where parts overlap: all must be known.
    if (!solid || !first || (leads_in && is_outside_of_bounds(ray.origin))) return first;
    std::vector<MeshCrossing<T>> list;
    crossings(ray, no_face, list);
    for (const MeshCrossing<T>& crossing : list)
        if (range.contains(crossing.t)) return crossing;
    return std::nullopt;
}

template <Numbers N>
auto Mesh<N>::closest(const Ray<T>& ray, const Range<T>& range, int leaving, const IsStart& is_start) const
    -> std::optional<MeshCrossing<T>> {
    bool leads_in = false;
    const auto counts = [&](const MeshCrossing<T>& crossing) {
        return int(crossing.triangle) != leaving && !is_start(crossing);
    };
    const auto first = nearest(ray, range, counts, leads_in);
    if (!solid || !first || leads_in) return first;
    std::vector<MeshCrossing<T>> list;
    crossings(ray, leaving, list);
    for (const MeshCrossing<T>& crossing : list)
        if (range.contains(crossing.t) && !is_start(crossing)) return crossing;
    return std::nullopt;
}

template <Numbers N> auto Mesh<N>::intervals(const Ray<T>& ray, int leaving) const -> Intervals<T> {
    std::vector<MeshCrossing<T>> list;
    crossings(ray, leaving, list);
    Intervals<T> found;
    const std::size_t step = solid ? 2 : 1;
    for (std::size_t i = 0; i < list.size() && found.count < 2; i += step) {
        const MeshCrossing<T>&enter = list[i], &exit = list[i + step - 1];
        found.append({enter.t, exit.t, int(enter.triangle), int(exit.triangle)});
    }
    return found;
}

template <Numbers N> auto Mesh<N>::normal(const Vec3<T>& p, int triangle) const -> Vec3<T> {
    const Edges t = edges(triangle, p);
    const Vec3<T> n = t.area();
    if (dot(n, n) > T(0)) return n;
    // Without area: some vector at right angles to an edge, so that nothing has to be divided by zero.
    const Vec3<T> size = absolute(t.ab);
    const Vec3<T> axis = size.x > size.y ? Vec3<T>{T(0), T(1), T(0)} : Vec3<T>{T(1), T(0), T(0)};
    const Vec3<T> across = cross(t.ab, axis);
    return dot(across, across) > T(0) ? across : Vec3<T>{T(0), T(0), T(1)};
}

template <Numbers N> auto Mesh<N>::value(const Vec3<T>& p, int triangle) const -> T {
    const Corners t = corners(std::size_t(triangle));
    return magnitude(dot(normalized(edges(triangle, p).area()), p - t.a));
}

// Each component of the two edges is rounded by half an ε: with them the normal by ε |edge| |edge|, and the plane at p by
// as much times the distance from the corner that it is hung up on.
template <Numbers N> auto Mesh<N>::tilt(const Vec3<T>& p, int triangle) const -> T {
    const Edges t = edges(triangle, p);
    return T(4) * epsilon<T> * length(t.ab) * length(t.ac) * length(p - corners(std::size_t(triangle)).a);
}

template <Numbers N> auto Mesh<N>::barycentric(const Vec3<T>& p, int triangle) const -> Vec3<T> {
    const Edges t = edges(triangle, p);
    const Vec3<T> n = t.area();
    const T whole = dot(n, n);
    if (!(whole > T(0))) return {T(1), T(0), T(0)};
    const T b = dot(n, cross(t.ap, t.ac)) / whole;
    const T c = dot(n, cross(t.ab, t.ap)) / whole;
    return {T(1) - b - c, b, c};
}

template <Numbers N> auto Mesh<N>::shading_normal(const Vec3<T>& p, int triangle) const -> Vec3<T> {
    if (!smooth()) return normal(p, triangle);
    const MeshData& data = triangles_->data();
    const MeshData::Corners& corner = data.normals_of(std::size_t(triangle));
    const Vec3<T> share = barycentric(p, triangle);
    Vec3<T> sum{T(0)};
    for (int i = 0; i < 3; ++i) sum += share[i] * normalized(as<T>(data.normals[corner[std::size_t(i)]]));
    return length(sum) > T(0) ? sum : normal(p, triangle);
}

template <Numbers N> bool Mesh<N>::contains(const Vec3<T>& p) const {
    if (!solid || is_outside_of_bounds(p)) return false;
    std::vector<MeshCrossing<T>> list;
    all({p, {T(0), T(0), T(1)}}, list);
    int turns = 0;
    for (const MeshCrossing<T>& crossing : list) {
        if (crossing.t > T(0)) break;
        turns += crossing.entering ? 1 : -1;
    }
    return turns > 0;
}

template <Numbers N> auto Mesh<N>::value(const Vec3<T>& p) const -> T {
    const T distance = T(triangles_->distance(as<double>(p)));
    return contains(p) ? -distance : distance;
}

template class Mesh<float>;
template class Mesh<double>;
template class Mesh<long double>;
template class Mesh<Float128>;
template class Mesh<Textbook<float>>;
template class Mesh<Textbook<double>>;
template class Mesh<Textbook<long double>>;
template class Mesh<Textbook<Float128>>;
template class Mesh<Substituted>;

} // namespace rayscope
