#include "core/povray/flush_faces.hpp"

#include "core/povray/words.hpp"
#include "core/scene/expand.hpp"

namespace rayscope::povray {
namespace {

struct FlatFace {
    Vec3d point, normal; // world; unit
    std::size_t leaf;
};

struct Leaf {
    std::size_t generic;
    Box<double> bounds; // world
};

// A point of each flat face, which is its outward normal as well, but for the half space's.
std::vector<Vec3d> flat_faces(const Generic<double>& generic) {
    if (std::holds_alternative<Cylinder<double>>(generic)) return {{0, 0, 1}, {0, 0, -1}};
    if (const auto* cone = std::get_if<Cone<double>>(&generic)) {
        if (cone->top > 0) return {{0, 0, 1}, {0, 0, -1}};
        return {{0, 0, -1}};
    }
    if (std::holds_alternative<Cube<double>>(generic))
        return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    return {};
}

Box<double> moved(const Mat4d& matrix, const Box<double>& box) {
    if (!box.bounded()) return Box<double>::everything();
    Box<double> result;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3d p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
        result.include(moved_point(matrix, p));
    }
    return result;
}

// Within what rounding of the matrices can part.
bool same_plane(const FlatFace& a, const FlatFace& b) {
    const double rounding = 64 * epsilon<double>;
    const double size = length(a.point) + length(b.point);
    return length(cross(a.normal, b.normal)) <= rounding &&
           magnitude(dot(a.normal, b.point - a.point)) <= rounding * size;
}

bool meet(const Box<double>& a, const Box<double>& b) {
    for (int i = 0; i < 3; ++i)
        if (a.high[i] < b.low[i] || b.high[i] < a.low[i]) return false;
    return true;
}

} // namespace

std::optional<std::pair<std::size_t, std::size_t>> flush_operands(const Scene& scene, std::size_t compound) {
    constexpr std::size_t most_faces = 2000; // every pair is looked at
    std::vector<FlatFace> faces;
    std::vector<Leaf> leaves;
    for (const ExpandedNode& node : expand(scene, compound)) {
        if (node.operation != Operation::leaf) continue;
        const Generic<double>& shape = scene.generics[node.generic].shape;
        const Transform<double> transform(node.matrix);
        for (const Vec3d& face : flat_faces(shape))
            faces.push_back({moved_point(node.matrix, face), transform.normal_to_world(face), leaves.size()});
        if (std::holds_alternative<Plane<double>>(shape))
            faces.push_back({Vec3d{node.matrix[3]}, transform.normal_to_world({0, 0, 1}), leaves.size()});
        const auto bounds = std::visit([](const auto& s) { return s.bounds(); }, shape);
        leaves.push_back({node.generic, moved(node.matrix, bounds)});
        if (faces.size() > most_faces) return std::nullopt;
    }
    for (std::size_t i = 0; i < faces.size(); ++i)
        for (std::size_t j = i + 1; j < faces.size(); ++j) {
            const Leaf &a = leaves[faces[i].leaf], &b = leaves[faces[j].leaf];
            if (&a != &b && same_plane(faces[i], faces[j]) && meet(a.bounds, b.bounds))
                return std::pair(a.generic, b.generic);
        }
    return std::nullopt;
}

} // namespace rayscope::povray
