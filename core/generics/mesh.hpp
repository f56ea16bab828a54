#pragma once
// Triangles that share their vertices. A closed mesh is a solid, an open one a surface. Its faces are the triangles, in
// the order of the file, and a line may cross any number of them.

#include "core/generics/spans.hpp"
#include "core/math/box.hpp"
#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"
#include "core/mesh/triangle_mesh.hpp"

#include <functional>
#include <memory>
#include <optional>

namespace rayscope {

/// Where a line passes through a triangle, and whether against its normal.
template <Scalar T> struct MeshCrossing {
    T t;
    std::uint32_t triangle;
    bool entering;
};

template <Numbers N> class Mesh {
public:
    using T = ScalarOf<N>;

    static constexpr const char* name = "mesh";

    explicit Mesh(std::shared_ptr<const TriangleMesh> triangles)
        : solid(!triangles->hole()), triangles_(std::move(triangles)) {}

    bool solid; ///< closed

    /// A closed mesh's crossings with the whole line ascend, entering and leaving in turn; their number is even. Inside is
    /// what the triangles run around more often one way than the other, so parts of it may overlap.
    /// @param out replaced
    /// @param leaving the triangle on which the ray starts: its crossing is then t = 0 exactly; or no_face
    void crossings(const Ray<T>& ray, int leaving, std::vector<MeshCrossing<T>>& out) const;

    /// The first of these crossings with t in the range, whose min is not negative.
    [[nodiscard]] std::optional<MeshCrossing<T>> closest(const Ray<T>& ray, const Range<T>& range) const;

    /// The same for a ray that starts on a triangle, on the outside of a closed mesh.
    /// @param is_start whether a crossing is the start once more: then it does not count
    using IsStart = std::function<bool(const MeshCrossing<T>&)>;
    [[nodiscard]] std::optional<MeshCrossing<T>> closest(const Ray<T>& ray, const Range<T>& range,
                                                         int leaving, const IsStart& is_start) const;

    /// What convex shapes answer: of a mesh it is but the first two intervals.
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray, int leaving = no_face) const;

    /// Outward, of any length.
    [[nodiscard]] Vec3<T> normal(const Vec3<T>& p, int triangle) const;
    /// Interpolated between those of the corners, where they have any.
    [[nodiscard]] Vec3<T> shading_normal(const Vec3<T>& p, int triangle) const;
    /// What share each corner has in a point of a triangle: they add up to 1.
    [[nodiscard]] Vec3<T> barycentric(const Vec3<T>& p, int triangle) const;

    /// Distance from a triangle's plane.
    [[nodiscard]] T value(const Vec3<T>& p, int triangle) const;
    /// Distance from the nearest triangle, negative inside.
    [[nodiscard]] T value(const Vec3<T>& p) const;
    [[nodiscard]] bool contains(const Vec3<T>& p) const;
    [[nodiscard]] T curvature(const Vec3<T>&, const Vec3<T>&, int /*triangle*/) const { return T(0); }
    /// How far, times the length of the normal, rounding of that normal may tilt the triangle away from p.
    [[nodiscard]] T tilt(const Vec3<T>& p, int triangle) const;
    [[nodiscard]] Box<T> bounds() const { return as<T>(triangles_->bounds()); }

    [[nodiscard]] const TriangleMesh& triangles() const { return *triangles_; }
    [[nodiscard]] bool smooth() const { return triangles_->data().smooth(); }
    template <Numbers M> [[nodiscard]] Mesh<M> to() const { return Mesh<M>(triangles_); }

private:
    struct Corners {
        Vec3<T> a, b, c;
    };
    [[nodiscard]] Corners corners(std::size_t triangle) const {
        const MeshData& data = triangles_->data();
        const MeshData::Corners& t = data.triangles[triangle];
        return {as<T>(data.positions[t[0]]), as<T>(data.positions[t[1]]), as<T>(data.positions[t[2]])};
    }
    /// Two edges and the way to a point from the corner between them, in the mesh's own scale: the square of an area
    /// is a number in it.
    struct Edges {
        Vec3<T> ab, ac, ap;
        [[nodiscard]] Vec3<T> area() const { return cross(ab, ac); }
    };
    [[nodiscard]] Edges edges(int triangle, const Vec3<T>& p) const {
        const Corners t = corners(std::size_t(triangle));
        const T scale = is_finite(T(triangles_->scale())) ? T(triangles_->scale()) : T(1);
        return {(t.b - t.a) * scale, (t.c - t.a) * scale, (p - t.a) * scale};
    }
    [[nodiscard]] bool is_outside_of_bounds(const Vec3<T>& p) const;
    template <typename Counts>
    [[nodiscard]] std::optional<MeshCrossing<T>> nearest(const Ray<T>& ray, const Range<T>& range,
                                                         const Counts& counts, bool& leads_in) const;
    void all(const Ray<T>& ray, std::vector<MeshCrossing<T>>& out) const;
    void settle(std::vector<MeshCrossing<T>>& list) const;

    // A ray of wider numbers is rounded to double where triangles are left out.
    static constexpr double kernel_unit = std::is_same_v<T, float> ? double(epsilon<float>) : epsilon<double>;

    std::shared_ptr<const TriangleMesh> triangles_;
};

extern template class Mesh<float>;
extern template class Mesh<double>;
extern template class Mesh<long double>;
extern template class Mesh<Float128>;
extern template class Mesh<Textbook<float>>;
extern template class Mesh<Textbook<double>>;
extern template class Mesh<Textbook<long double>>;
extern template class Mesh<Textbook<Float128>>;

} // namespace rayscope
