#include "core/scene/build.hpp"

#include "core/boxes/slab_ray.hpp"
#include "core/generics/test_costs.hpp"
#include "core/math/substituted.hpp"
#include "core/scene/expand.hpp"

#include <array>
#include <functional>

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

// A solid in the author's numbers.
struct Placed {
    const Generic<double>& shape;
    const Mat4d& matrix;
    std::uint32_t object, material;
    bool patterned;     // in its own space
    Box<double> bounds; // in world space
};

// See Solid::reach.
double reach_of(const Placed& placed) {
    const Box<double>& b = placed.bounds;
    if (b.bounded()) return largest_component(absolute(b.low)) + largest_component(absolute(b.high));
    double reach = 0;
    for (int column = 0; column < 4; ++column)
        reach += largest_component(absolute(Vec3d{placed.matrix[column]}));
    return reach;
}

// A sphere that no matrix distorts needs none, but for a pattern, or for formulas of somebody else's that are to be asked
// about it: it is put at its place in world space.
template <Numbers N> Solid<N> solid_of(const Placed& placed) {
    using T = ScalarOf<N>;
    Solid<N> solid;
    solid.object = placed.object;
    solid.material = placed.material;
    solid.reach = T(reach_of(placed));
    const auto* sphere = std::get_if<Sphere<double>>(&placed.shape);
    const bool needs_matrix = placed.patterned || std::is_same_v<N, Substituted>;
    const T scale = sphere != nullptr && !needs_matrix ? similarity_scale<T>(placed.matrix) : T(0);
    if (scale > T(0)) {
        solid.transform = Transform<N>::moving(Vec3d{placed.matrix[3]});
        solid.shape = Sphere<N>{scale * T(sphere->radius)};
        solid.is_ball = true;
    } else {
        solid.transform = Transform<N>(placed.matrix);
        solid.shape = to_numbers<N>(placed.shape);
    }
    return solid;
}

// Builds what all numbers share, and hands out the solids one by one.
class Builder {
public:
    Builder(const Scene& scene, std::function<void(const Placed&)> place)
        : scene_(scene), place_(std::move(place)) {}

    WorldBase build() {
        copy_settings();
        world_.objects.reserve(scene_.drawn.size());
        for (const SceneObject& object : scene_.drawn)
            object.is_compound ? add_compound(object.index) : add_generic(object.index);
        return std::move(world_);
    }

private:
    void copy_settings() {
        for (const SceneMaterial& m : scene_.materials) world_.materials.push_back(material_of(m));
        for (const SceneLight& l : scene_.lights) {
            const LightArea area = l.shines() ? l.area : LightArea{};
            world_.lights.push_back({l.directional, l.position, l.colour, l.shines() && l.shadows, area});
            if (area.is_sampled()) world_.effects = EffectMask::all;
        }
        world_.background = scene_.background;
        world_.ambient = scene_.ambient;
        world_.notes_media = scene_.notes_media;
        world_.medium_speed = scene_.medium_speed;
        world_.max_depth = scene_.limits.max_depth;
        world_.min_weight = scene_.limits.min_weight;
        world_.max_rays = scene_.limits.max_rays;
        world_.wavelengths = scene_.limits.wavelengths;
    }

    Material material_of(const SceneMaterial& m) {
        Material material{m.ambient,    m.diffuse,      m.specular, m.shininess,
                          m.reflection, m.transmission, m.speed};
        material.mirror = m.mirror;
        if (m.mirror != Mirror::constant) {
            material.reflection = Colour{0};
            material.transmission = Colour{1}; // what is not reflected
        }
        material.absorption = m.absorption;
        material.dispersion = m.dispersion;
        if (m.patterns.any()) {
            material.patterns = Id(world_.patterns.size());
            world_.patterns.push_back(m.patterns);
            // Whether it is a medium is asked of the material as a whole.
            if (const auto& p = m.patterns.transmission) material.transmission = maximum_of(p->even, p->odd);
        }
        return material;
    }

    std::uint32_t required_material(const std::optional<std::size_t>& material, const std::string& what,
                                    Place place) const {
        if (!material) throw InputError(scene_.file, place, what + " is drawn and has no material");
        return std::uint32_t(*material);
    }

    // Adds the solid and returns the box around it.
    Box<double> add_solid(const SceneGeneric& generic, const Mat4d& matrix, std::uint32_t material) {
        const Box<double> bounds =
            transformed(std::visit([](const auto& shape) { return shape.bounds(); }, generic.shape), matrix);
        const bool patterned =
            scene_.materials[material].patterns.any() || scene_.materials[of_object_].patterns.any();
        place_({generic.shape, matrix, std::uint32_t(world_.objects.size()), material, patterned, bounds});
        ++solids_;
        return bounds;
    }

    void add_generic(std::size_t index) {
        const SceneGeneric& generic = scene_.generics[index];
        const auto material =
            required_material(generic.material, "generic '" + generic.name + "'", generic.place);
        of_object_ = material;
        const std::uint32_t solid = solids_;
        const Box<double> bounds = add_solid(generic, generic.matrix, material);
        world_.objects.push_back({false, solid, material, generic.priority, is_solid(generic.shape), bounds});
        world_.note_effects(material, is_solid(generic.shape));
    }

    void add_compound(std::size_t index) {
        const SceneCompound& compound = scene_.compounds[index];
        const auto material =
            required_material(compound.material, "compound '" + compound.name + "'", compound.place);
        of_object_ = material;
        Compound result;
        std::vector<Box<double>> boxes;
        std::vector<NodeExtent> extents;
        const std::vector<ExpandedNode> tree = expand(scene_, index, max_nodes - nodes_);
        nodes_ += tree.size();
        for (const ExpandedNode& node : tree) {
            result.nodes.push_back({node.operation, node.left, node.right, solids_});
            const bool is_leaf = node.operation == Operation::leaf;
            boxes.push_back(is_leaf ? add_leaf(compound, node, material)
                                    : box_of(node, boxes, std::identity()));
            extents.push_back(is_leaf ? extent_of(node, boxes.back())
                                      : NodeExtent{box_of(node, extents, &NodeExtent::box)});
        }
        CompiledProgram compiled = compile(result.nodes, extents, boxes.back());
        result.program = std::move(compiled.program);
        result.extents = std::move(compiled.extents);
        const auto is_entered_once = [&](const ExpandedNode& node) {
            if (node.operation != Operation::leaf) return true;
            const auto& shape = scene_.generics[node.generic].shape;
            return !std::holds_alternative<Torus<double>>(shape) &&
                   !std::holds_alternative<Mesh<double>>(shape);
        };
        if (std::ranges::all_of(tree, is_entered_once)) result.table = truth_table(result.program);
        for (const PartExtent& part : result.extents)
            result.size = maximum(result.size, largest_coordinate(part.box));
        world_.objects.push_back(
            {true, std::uint32_t(world_.compounds.size()), material, compound.priority, true, boxes.back()});
        world_.note_effects(material, true);
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
        world_.note_effects(material, false);
        return add_solid(generic, leaf.matrix, material);
    }

    // What a matrix distorts too much has no box that could be relied on.
    NodeExtent extent_of(const ExpandedNode& leaf, const Box<double>& box) const {
        const bool distorted = Transform<double>(leaf.matrix).distortion() > most_distorted<double>;
        return {distorted ? Box<double>::everything() : box,
                test_costs[scene_.generics[leaf.generic].shape.index()]};
    }

    static Box<double> box_of(const ExpandedNode& node, const auto& boxes, auto box) {
        const auto of = [&](std::size_t i) -> const Box<double>& { return std::invoke(box, boxes[i]); };
        switch (node.operation) {
        case Operation::set_union: return united(of(node.left), of(node.right));
        case Operation::intersection: return intersected(of(node.left), of(node.right));
        case Operation::difference: return of(node.left);
        default: return Box<double>::everything();
        }
    }

    const Scene& scene_;
    std::function<void(const Placed&)> place_;
    WorldBase world_;
    std::uint32_t solids_ = 0;    // so far
    std::uint32_t of_object_ = 0; // material of the object that is being added
    std::size_t nodes_ = 0;       // of all compounds so far
};

} // namespace

namespace {

template <Numbers N> void mark_what_holds_objects(World<N>& world) {
    for (const Compound& compound : world.compounds) {
        std::size_t operand = 0;
        for (const Instruction& step : compound.program) {
            if (step.kind != Instruction::Kind::leaf) continue;
            world.solids[step.operand].holds_object =
                operand < compound.table.count && compound.table.lies_within(operand);
            ++operand;
        }
    }
}

template <Numbers N> MediumExtent medium_extent(const World<N>& world, const Object& object) {
    if (!object.is_compound)
        return {object.bounds, world.is_ball(object), double(world.solids[object.index].reach)};
    MediumExtent extent{object.bounds};
    for (const CompoundNode& node : world.compounds[object.index].nodes)
        if (node.operation == Operation::leaf)
            extent.reach = maximum(extent.reach, double(world.solids[node.solid].reach));
    return extent;
}

template <Numbers N> void gather_media(World<N>& world) {
    std::vector<std::uint32_t> transmitting;
    std::vector<MediumExtent> extents;
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (!object.has_volume || !world.material_of(object).transmits()) continue;
        transmitting.push_back(id);
        extents.push_back(medium_extent(world, object));
    }
    world.media = MediaNeighbours(std::move(transmitting), std::move(extents));
}

// Copies of the balls, where they are worth the memory.
template <Numbers N> void gather_balls(World<N>& world) {
    const auto is_ball = [&](const Object& object) { return world.is_ball(object); };
    if (4 * std::ranges::count_if(world.objects, is_ball) < std::ssize(world.objects)) return;
    world.balls.resize(world.objects.size());
    for (std::size_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (!is_ball(object)) continue;
        const Solid<N>& solid = world.solids[object.index];
        world.balls[id] = {solid.transform.translation(), std::get<Sphere<N>>(solid.shape), object.index};
    }
}

} // namespace

template <Numbers N> World<N> build(const Scene& scene) {
    World<N> world;
    static_cast<WorldBase&>(world) =
        Builder(scene, [&](const Placed& placed) { world.solids.push_back(solid_of<N>(placed)); }).build();
    mark_what_holds_objects(world);
    gather_media(world);
    gather_balls(world);
    return world;
}

template World<float> build(const Scene&);
template World<Textbook<float>> build(const Scene&);
template World<double> build(const Scene&);
template World<Textbook<double>> build(const Scene&);
template World<long double> build(const Scene&);
template World<Textbook<long double>> build(const Scene&);
template World<Float128> build(const Scene&);
template World<Textbook<Float128>> build(const Scene&);
template World<Substituted> build(const Scene&);

} // namespace rayscope
