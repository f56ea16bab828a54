#include "core/scene/build.hpp"

#include "core/scene/expand.hpp"

namespace rayscope {
namespace {

// The box around a transformed box, a little larger than rounding can move its corners.
Box<double> transformed(const Box<double>& box, const Mat4d& matrix) {
    if (!box.bounded()) return Box<double>::everything();
    Box<double> result;
    for (int corner = 0; corner < 8; ++corner) {
        Vec3d p{matrix[3]};
        Vec3d size = absolute(p);
        for (int axis = 0; axis < 3; ++axis) {
            const double coordinate = (corner >> axis & 1) != 0 ? box.high[axis] : box.low[axis];
            const Vec3d step = coordinate * Vec3d{matrix[axis]};
            p += step;
            size += absolute(step);
        }
        const Vec3d margin = 8 * epsilon<double> * size;
        result.include(p - margin);
        result.include(p + margin);
    }
    return result;
}

class Builder {
public:
    explicit Builder(const Scene& scene) : scene_(scene) {}

    World<double> build() {
        copy_settings();
        world_.objects.reserve(scene_.drawn.size());
        for (const SceneObject& object : scene_.drawn)
            object.is_compound ? add_compound(object.index) : add_generic(object.index);
        gather_media();
        return std::move(world_);
    }

private:
    void copy_settings() {
        for (const SceneMaterial& m : scene_.materials)
            world_.materials.push_back(
                {m.ambient, m.diffuse, m.specular, m.shininess, m.reflection, m.transmission, m.speed});
        for (const SceneLight& l : scene_.lights)
            world_.lights.push_back({l.directional, l.position, l.colour, l.shadows});
        world_.background = scene_.background;
        world_.ambient = scene_.ambient;
        world_.notes_media = scene_.notes_media;
        world_.medium_speed = scene_.medium_speed;
        world_.max_depth = scene_.limits.max_depth;
        world_.min_weight = scene_.limits.min_weight;
        world_.max_rays = scene_.limits.max_rays;
    }

    std::uint32_t required_material(const std::optional<std::size_t>& material, const std::string& what,
                                    Place place) const {
        if (!material) throw InputError(scene_.file, place, what + " is drawn and has no material");
        return std::uint32_t(*material);
    }

    // Adds the solid and returns the box around it.
    Box<double> add_solid(const SceneGeneric& generic, const Mat4d& matrix, std::uint32_t material) {
        Solid<double> solid;
        solid.object = std::uint32_t(world_.objects.size());
        solid.material = material;
        const double scale =
            std::holds_alternative<Sphere<double>>(generic.shape) ? similarity_scale(matrix) : 0;
        if (scale > 0) { // a sphere in world space needs no matrix
            Mat4d translation{1};
            translation[3] = matrix[3];
            solid.transform = Transform<double>(translation);
            solid.shape = Sphere<double>{scale};
            solid.is_ball = true;
        } else {
            solid.transform = Transform<double>(matrix);
            solid.shape = generic.shape;
        }
        world_.solids.push_back(std::move(solid));
        return transformed(std::visit([](const auto& shape) { return shape.bounds(); }, generic.shape),
                           matrix);
    }

    void add_generic(std::size_t index) {
        const SceneGeneric& generic = scene_.generics[index];
        const auto material =
            required_material(generic.material, "generic '" + generic.name + "'", generic.place);
        const auto solid = std::uint32_t(world_.solids.size());
        const Box<double> bounds = add_solid(generic, generic.matrix, material);
        world_.objects.push_back({false, solid, material, generic.priority, is_solid(generic.shape), bounds});
    }

    void add_compound(std::size_t index) {
        const SceneCompound& compound = scene_.compounds[index];
        const auto material =
            required_material(compound.material, "compound '" + compound.name + "'", compound.place);
        Compound result;
        std::vector<Box<double>> boxes;
        const std::vector<ExpandedNode> tree = expand(scene_, index, max_nodes - nodes_);
        nodes_ += tree.size();
        for (const ExpandedNode& node : tree) {
            result.nodes.push_back(
                {node.operation, node.left, node.right, std::uint32_t(world_.solids.size())});
            boxes.push_back(node.operation == Operation::leaf ? add_leaf(compound, node, material)
                                                              : box_of(node, boxes));
        }
        result.program = compile(result.nodes);
        world_.objects.push_back(
            {true, std::uint32_t(world_.compounds.size()), material, compound.priority, true, boxes.back()});
        world_.compounds.push_back(std::move(result));
    }

    // An operand's wall looks like its generic says, else like the innermost compound around it that says anything.
    Box<double> add_leaf(const SceneCompound& compound, const ExpandedNode& leaf, std::uint32_t material) {
        const SceneGeneric& generic = scene_.generics[leaf.generic];
        if (!is_invertible(leaf.matrix))
            throw InputError(scene_.file, compound.place,
                             "the matrices of compound '" + compound.name + "' and of its operand '" +
                                 generic.name + "' multiply to one that can't be inverted");
        if (leaf.material) material = std::uint32_t(*leaf.material);
        return add_solid(generic, leaf.matrix, material);
    }

    static Box<double> box_of(const ExpandedNode& node, const std::vector<Box<double>>& boxes) {
        switch (node.operation) {
        case Operation::set_union: return united(boxes[node.left], boxes[node.right]);
        case Operation::intersection: return intersected(boxes[node.left], boxes[node.right]);
        case Operation::difference: return boxes[node.left];
        default: return Box<double>::everything();
        }
    }

    void gather_media() {
        std::vector<std::uint32_t> transmitting;
        std::vector<Box<double>> bounds;
        for (std::uint32_t id = 0; id < world_.objects.size(); ++id) {
            const Object& object = world_.objects[id];
            if (!object.has_volume || !world_.material_of(object).transmits()) continue;
            transmitting.push_back(id);
            bounds.push_back(object.bounds);
        }
        world_.media = MediaNeighbours(std::move(transmitting), bounds);
    }

    const Scene& scene_;
    World<double> world_;
    std::size_t nodes_ = 0; // of all compounds so far
};

} // namespace

World<double> build(const Scene& scene) { return Builder(scene).build(); }

} // namespace rayscope
