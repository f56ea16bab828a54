#include "core/scene/name_trace.hpp"

#include "core/scene/expand.hpp"

#include <unordered_map>

namespace rayscope {
namespace {

const char* symbol(Operation operation) {
    switch (operation) {
    case Operation::set_union: return " ∪ ";
    case Operation::intersection: return " ∩ ";
    case Operation::difference: return " − ";
    default: return "";
    }
}

// Expressions longer than this are cut: in a chain of 10⁵ operands each node would repeat all before it.
constexpr std::size_t longest_expression = 72;

std::string operand_text(const TraceNode& node, bool named) {
    return node.operation == Operation::leaf || node.operation == Operation::complement || named
               ? node.name
               : "(" + node.name + ")";
}

class Namer {
public:
    Namer(Trace& trace, const Scene& scene, const World<double>& world)
        : trace_(trace), scene_(scene), world_(world) {
        trace_.media.push_back({"air", world.medium_speed});
        if (world.medium_speed != 1) trace_.media.front().name = "surroundings";
        for (const SceneLight& light : scene.lights)
            trace_.lights.push_back({light.name, light.directional, light.position});
    }

    void operator()(RaySpawned& e) {
        e.medium = medium(e.medium);
        e.left_object = object(e.left_object);
    }
    void operator()(PlaceEntered& e) { e.object = object(e.object); }
    void operator()(ObjectAccepted& e) { e.object = object(e.object); }
    void operator()(NodeEvaluated& e) { e.object = object(e.object); }
    void operator()(SpanFound& e) {
        e.enter.leaf = solid(e.enter.leaf);
        e.exit.leaf = solid(e.exit.leaf);
    }
    void operator()(ClusterMerged& e) { e.object = object(e.object); }
    void operator()(Absorbed& e) { e.medium = medium(e.medium); }
    void operator()(BlockerPassed& e) { e.object = object(e.object); }
    void operator()(BoundaryChosen& e) {
        e.object = object(e.object);
        e.boundary.leaf = solid(e.boundary.leaf);
        e.medium_from = medium(e.medium_from);
        e.medium_to = medium(e.medium_to);
    }
    void operator()(auto&) {}

private:
    Id object(Id world_id) {
        if (world_id == none) return none;
        const auto [at, fresh] = objects_.try_emplace(world_id, Id(trace_.objects.size()));
        if (fresh) {
            trace_.objects.emplace_back();
            describe(std::size_t(world_id), trace_.objects.back());
        }
        return at->second;
    }

    // The solids of an object are numbered when the object is.
    Id solid(Id world_id) {
        if (world_id == none) return none;
        object(Id(world_.solids[std::size_t(world_id)].object));
        return solids_.at(world_id);
    }

    Id medium(Id world_id) {
        if (world_id == none) return 0;
        const auto [at, fresh] = media_.try_emplace(world_id, Id(trace_.media.size()));
        if (fresh) {
            const SceneObject& drawn = scene_.drawn[std::size_t(world_id)];
            trace_.media.push_back(
                {object_title(scene_, drawn), world_.material_of(std::uint32_t(world_id)).speed});
        }
        return at->second;
    }

    void describe(std::size_t world_id, TraceObject& result) {
        const Object& object = world_.objects[world_id];
        const SceneObject& drawn = scene_.drawn[world_id];
        result.name = object_title(scene_, drawn);
        result.material = scene_.materials[object.material].name;
        if (!drawn.is_compound) {
            result.nodes.push_back(leaf(drawn.index, object.index));
            return;
        }
        const Compound& compound = world_.compounds[object.index];
        std::vector<bool> named;
        for (const ExpandedNode& node : expand(scene_, drawn.index)) {
            const SceneCompound& author = scene_.compounds[node.compound];
            const bool is_root = node.node + 1 == author.nodes.size();
            if (node.operation == Operation::leaf) {
                result.nodes.push_back(leaf(node.generic, compound.nodes[result.nodes.size()].solid));
            } else {
                TraceNode inner{node.operation, Id(node.left), none, none, {}};
                if (node.operation != Operation::complement) inner.right = Id(node.right);
                inner.name = is_root && node.compound != drawn.index ? author.name
                                                                     : expression(inner, result.nodes, named);
                result.nodes.push_back(std::move(inner));
            }
            named.push_back(is_root && node.compound != drawn.index);
        }
    }

    TraceNode leaf(std::size_t generic, std::uint32_t solid) {
        solids_.emplace(Id(solid), Id(trace_.generics.size()));
        trace_.generics.push_back(generic_title(scene_, generic));
        return {Operation::leaf, none, none, Id(trace_.generics.size() - 1), trace_.generics.back()};
    }

    static std::string expression(const TraceNode& node, const std::vector<TraceNode>& nodes,
                                  const std::vector<bool>& named) {
        const auto text = [&](Id operand) {
            return operand_text(nodes[std::size_t(operand)], named[std::size_t(operand)]);
        };
        const auto shortened = [](const std::string& s) {
            return s.size() <= longest_expression / 2 ? s : std::string("(…)");
        };
        if (node.operation == Operation::complement) return "¬" + shortened(text(node.left));
        const std::string left = text(node.left), right = text(node.right);
        if (left.size() + right.size() <= longest_expression) return left + symbol(node.operation) + right;
        return shortened(left) + symbol(node.operation) + shortened(right);
    }

    Trace& trace_;
    const Scene& scene_;
    const World<double>& world_;
    std::unordered_map<Id, Id> objects_, solids_, media_;
};

} // namespace

std::string generic_title(const Scene& scene, std::size_t index) {
    const SceneGeneric& generic = scene.generics[index];
    if (!generic.name.empty()) return generic.name;
    return std::string(generic_name(generic.shape)) + " #" + std::to_string(index);
}

std::string object_title(const Scene& scene, const SceneObject& drawn) {
    return drawn.is_compound ? scene.compounds[drawn.index].name : generic_title(scene, drawn.index);
}

void name_trace(Trace& trace, const Scene& scene, const World<double>& world) {
    Namer namer(trace, scene, world);
    for (TracedRay& ray : trace.rays)
        for (Event& event : ray.events) std::visit(namer, event);
}

} // namespace rayscope
