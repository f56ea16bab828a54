#include "visualizer/drawing/clip_compound.hpp"

#include "visualizer/drawing/merging.hpp"

#include <vtkClipPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>

#include <algorithm>

namespace rayscope::drawing {
namespace {

/// A face that two leaves share belongs to the left one: the border is moved by this much of a generic's size.
constexpr double shared_face = 1e-6;

enum class Keep : std::uint8_t { inside, outside };

/// A leaf's wall belongs to the compound where it lies inside, or outside, a sibling on the path to the root.
struct Condition {
    std::uint32_t sibling;
    Keep keep;
    double tolerance;
};

class Tree {
public:
    explicit Tree(const Scene& scene, std::vector<ExpandedNode> nodes)
        : scene_(scene), nodes_(std::move(nodes)) {
        parents_.assign(nodes_.size(), std::uint32_t(nodes_.size()));
        for (std::uint32_t i = 0; i < nodes_.size(); ++i) {
            if (nodes_[i].operation == Operation::leaf) {
                to_object_.emplace_back(nodes_[i].matrix);
                continue;
            }
            to_object_.emplace_back();
            parents_[nodes_[i].left] = i;
            if (nodes_[i].operation != Operation::complement) parents_[nodes_[i].right] = i;
        }
    }

    [[nodiscard]] std::vector<Condition> conditions(std::uint32_t leaf) const {
        std::vector<Condition> found;
        for (std::uint32_t child = leaf; parents_[child] < nodes_.size(); child = parents_[child]) {
            const ExpandedNode& parent = nodes_[parents_[child]];
            const bool left = parent.left == child;
            const std::uint32_t sibling = left ? parent.right : parent.left;
            switch (parent.operation) {
            case Operation::set_union:
                found.push_back({sibling, Keep::outside, left ? shared_face : -shared_face});
                break;
            case Operation::intersection:
                found.push_back({sibling, Keep::inside, left ? shared_face : -shared_face});
                break;
            case Operation::difference:
                found.push_back({sibling, left ? Keep::outside : Keep::inside, -shared_face});
                break;
            default: break;
            }
        }
        return found;
    }

    /// Negative where the condition holds.
    [[nodiscard]] double value(const Condition& condition, const Vec3d& world) const {
        const double v = value(condition.sibling, world);
        return (condition.keep == Keep::inside ? v : -v) - condition.tolerance;
    }

private:
    [[nodiscard]] double value(std::uint32_t node, const Vec3d& world) const {
        const ExpandedNode& n = nodes_[node];
        switch (n.operation) {
        case Operation::leaf:
            return implicit_value(scene_.generics[n.generic].shape, to_object_[node].point_to_object(world));
        case Operation::set_union: return std::min(value(n.left, world), value(n.right, world));
        case Operation::intersection: return std::max(value(n.left, world), value(n.right, world));
        case Operation::difference: return std::max(value(n.left, world), -value(n.right, world));
        default: return -value(n.left, world);
        }
    }

    const Scene& scene_;
    std::vector<ExpandedNode> nodes_;
    std::vector<std::uint32_t> parents_;
    std::vector<Transform<double>> to_object_;
};

} // namespace

Vec3d point_of(vtkPolyData* piece, vtkIdType id) {
    Vec3d p;
    piece->GetPoint(id, &p.x);
    return p;
}

vtkSmartPointer<vtkPolyData> kept_below_zero(const vtkSmartPointer<vtkPolyData>& piece,
                                             const std::vector<double>& values) {
    if (std::ranges::all_of(values, [](double v) { return v < 0; })) return piece;
    if (std::ranges::none_of(values, [](double v) { return v < 0; })) return nullptr;
    vtkNew<vtkDoubleArray> scalars;
    for (const double value : values) scalars->InsertNextValue(value);
    vtkNew<vtkPolyData> input;
    input->ShallowCopy(piece);
    input->GetPointData()->SetScalars(scalars);
    vtkNew<vtkClipPolyData> clip;
    clip->SetLocator(merging(piece->GetNumberOfPoints()));
    clip->SetInputData(input);
    clip->InsideOutOn();
    clip->Update();
    vtkSmartPointer<vtkPolyData> kept = clip->GetOutput();
    kept->GetPointData()->SetScalars(nullptr);
    return kept->GetNumberOfCells() > 0 ? kept : nullptr;
}

Pieces object_surface(const Scene& scene, std::size_t drawn, const Fineness& fineness, const Region& region) {
    const SceneObject& object = scene.drawn[drawn];
    if (!object.is_compound) {
        const SceneGeneric& generic = scene.generics[object.index];
        return tessellate(generic.shape, generic.matrix, fineness, region);
    }
    const std::vector<ExpandedNode> nodes = expand(scene, object.index);
    if (nodes.size() > 2 * most_leaves) return {};
    const Tree tree(scene, nodes);
    Pieces surface;
    for (std::uint32_t leaf = 0; leaf < nodes.size(); ++leaf) {
        if (nodes[leaf].operation != Operation::leaf) continue;
        const std::vector<Condition> conditions = tree.conditions(leaf);
        const Fineness fine{fineness.around, !conditions.empty()};
        for (vtkSmartPointer<vtkPolyData> piece :
             tessellate(scene.generics[nodes[leaf].generic].shape, nodes[leaf].matrix, fine, region)) {
            for (const Condition& condition : conditions) {
                std::vector<double> values;
                for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i)
                    values.push_back(tree.value(condition, point_of(piece, i)));
                piece = kept_below_zero(piece, values);
                if (piece == nullptr) break;
            }
            if (piece != nullptr) surface.push_back(piece);
        }
    }
    return surface;
}

} // namespace rayscope::drawing
