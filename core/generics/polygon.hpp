#pragma once
// A flat polygon, possibly concave: a surface, not a solid. Face 0; its normal follows the order of its vertices,
// counter-clockwise as seen from the side that it points to.

#include "core/generics/spans.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

#include <optional>
#include <utility>
#include <vector>

namespace rayscope {

template <Numbers N> class Polygon {
public:
    using T = ScalarOf<N>;

    static constexpr const char* name = "polygon";
    static constexpr bool solid = false;

    Polygon() = default;
    /// @param vertices at least three, flat, not all on one line
    /// @param normals one for each vertex, for smooth shading; or none. With them the triangles from the first vertex to
    /// each side must be the polygon, as those of a convex one are: they are interpolated in these
    explicit Polygon(std::vector<Vec3<T>> vertices, std::vector<Vec3<T>> normals = {});

    /// One crossing without length, where the line meets the plane within the outline.
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const;

    /// t of that crossing, if it lies in the range: elsewhere the outline is not asked.
    [[nodiscard]] std::optional<T> closest(const Ray<T>& ray, const Range<T>& range) const;

    [[nodiscard]] Vec3<T> normal(const Vec3<T>& /*p*/, int /*face*/) const { return normal_; }
    /// Where the corners have normals: interpolated at p of the outline; elsewhere the polygon's own. Not unit.
    [[nodiscard]] Vec3<T> shading_normal(const Vec3<T>& p) const;
    /// Distance from the plane; never negative, since nothing is inside.
    [[nodiscard]] T value(const Vec3<T>& p) const { return magnitude(dot(normal_, p - vertices_.front())); }
    [[nodiscard]] T curvature(const Vec3<T>&, const Vec3<T>&, int /*face*/) const { return T(0); }
    [[nodiscard]] Box<T> bounds() const;

    [[nodiscard]] const std::vector<Vec3<T>>& vertices() const { return vertices_; }
    [[nodiscard]] const std::vector<Vec3<T>>& normals() const { return normals_; }
    template <Numbers M> [[nodiscard]] Polygon<M> to() const;
    [[nodiscard]] bool smooth() const { return !normals_.empty(); }

private:
    /// Where the line meets the plane; not finite where it does not.
    [[nodiscard]] T plane_crossing(const Ray<T>& ray) const {
        const T slope = dot(normal_, ray.direction);
        return slope == T(0) ? infinity<T> : dot(normal_, vertices_.front() - ray.origin) / slope;
    }
    /// Two discs about one point of the plane: the one lies within the outline, the other holds it.
    struct Discs {
        Vec3<T> middle{T(0)};
        T within = T(0), around = infinity<T>; ///< radii
        T size = T(0);                         ///< largest coordinate of the outline
    };
    [[nodiscard]] Discs discs() const;
    /// Whether the line meets the plane, at this t, within the outline, where the discs can tell.
    [[nodiscard]] std::optional<bool> encloses_clearly(const Ray<T>& ray, T t) const;
    /// Whether the line meets the plane, at this t, within the outline.
    [[nodiscard]] bool encloses(const Ray<T>& ray, T t) const;
    [[nodiscard]] bool encloses_in_projection(const Vec3<T>& p) const;

    std::vector<Vec3<T>> vertices_, normals_;
    Vec3<T> normal_{T(0), T(0), T(1)};
    Discs discs_;
};

/// Twice the area vector of a polygon (Newell): its direction is the normal, zero for a degenerate outline.
template <Scalar T> [[nodiscard]] Vec3<T> area_vector(const std::vector<Vec3<T>>& vertices) {
    Vec3<T> sum{T(0)};
    for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
        sum += cross(vertices[i] - vertices[0], vertices[i + 1] - vertices[0]);
    return sum;
}

template <Numbers N> template <Numbers M> Polygon<M> Polygon<N>::to() const {
    if constexpr (std::is_same_v<M, N>) return *this;
    const auto converted = [](const std::vector<Vec3<T>>& vectors) {
        std::vector<Vec3<ScalarOf<M>>> result;
        for (const Vec3<T>& v : vectors) result.push_back(as<ScalarOf<M>>(v));
        return result;
    };
    return Polygon<M>(converted(vertices_), converted(normals_));
}

extern template class Polygon<float>;
extern template class Polygon<double>;
extern template class Polygon<long double>;
extern template class Polygon<Float128>;
extern template class Polygon<Textbook<float>>;
extern template class Polygon<Textbook<double>>;
extern template class Polygon<Textbook<long double>>;
extern template class Polygon<Textbook<Float128>>;

} // namespace rayscope
