#include "tests/oracle/case_world.hpp"

#include <array>

namespace rayscope::test {
namespace {

constexpr std::size_t outside_of_list = static_cast<std::size_t>(-1);

std::string leaf_name(std::size_t leaf) { return "leaf" + std::to_string(leaf); }

// A material for each leaf, by whose shininess its walls are recognized in the world.
SceneMaterial mark(std::size_t leaf) {
    SceneMaterial material;
    material.name = "of_" + leaf_name(leaf);
    material.shininess = static_cast<double>(leaf + 1);
    return material;
}

SceneCompound compound_of(const LineCase& exact) {
    SceneCompound compound;
    compound.name = "compound";
    std::vector<std::size_t> stack;
    for (const CaseToken& token : exact.program) {
        SceneNode node;
        node.operation = token.operation;
        if (token.operation == Operation::leaf) {
            node.operand = token.leaf;
        } else if (token.operation == Operation::complement) {
            node.left = stack.back();
            stack.pop_back();
        } else {
            node.right = stack.back();
            stack.pop_back();
            node.left = stack.back();
            stack.pop_back();
        }
        stack.push_back(compound.nodes.size());
        compound.nodes.push_back(node);
    }
    return compound;
}

Scene scene_of(const LineCase& exact) {
    Scene scene;
    scene.file = exact.id;
    scene.limits.max_depth = 0; // one ray, whatever its materials would send out
    for (std::size_t i = 0; i < exact.leaves.size(); ++i) {
        scene.materials.push_back(mark(i));
        SceneGeneric generic;
        generic.name = leaf_name(i);
        generic.shape = exact.leaves[i].shape;
        generic.matrix = exact.leaves[i].matrix;
        generic.material = i;
        generic.visible = !exact.is_compound;
        scene.generics.push_back(generic);
    }
    if (exact.is_compound) {
        scene.compounds.push_back(compound_of(exact));
        scene.compounds.back().material = 0;
    }
    scene.drawn.push_back({exact.is_compound, 0});
    return scene;
}

std::string face_name(const Generic<double>& shape, int face) {
    constexpr std::array cube{"-x", "+x", "-y", "+y", "-z", "+z"};
    constexpr std::array cylinder{"side", "cap-", "cap+"};
    constexpr std::array cone{"side", "cap-", "apex"};
    const auto index = static_cast<std::size_t>(face);
    if (std::holds_alternative<Cube<double>>(shape)) return cube.at(index);
    if (std::holds_alternative<Cylinder<double>>(shape)) return cylinder.at(index);
    if (std::holds_alternative<Cone<double>>(shape)) return cone.at(index);
    if (std::holds_alternative<Sphere<double>>(shape)) return "side";
    return generic_name(shape); // plane and torus have one face
}

std::size_t leaf_with_name(const LineCase& exact, const std::string& name) {
    for (std::size_t i = 0; i < exact.leaves.size(); ++i)
        if (name == leaf_name(i)) return i;
    return outside_of_list;
}

} // namespace

CaseWorld::CaseWorld(const LineCase& exact) : exact_(exact), bench_(make_workbench(scene_of(exact))) {}

FoundEnd CaseWorld::end_from(const Crossing<double>& crossing) const {
    FoundEnd end;
    end.t = crossing.t;
    if (!std::isfinite(crossing.t)) return end;
    const Solid<double>& solid = bench_.world.solids.at(crossing.surface.solid);
    const int face = crossing.surface.face;
    end.leaf = static_cast<std::size_t>(bench_.world.materials.at(solid.material).shininess) - 1;
    end.face = face_name(solid.shape, face);
    end.flipped = crossing.surface.flipped;
    end.error_bound = solid.error_bound(exact_.ray, crossing.t, face);
    end.normal = solid.normal(exact_.ray, crossing.t, face);
    if (end.flipped) end.normal = -end.normal;
    return end;
}

FoundSpans CaseWorld::spans() const {
    const auto lists = rayscope::spans(bench_, exact_.ray);
    FoundSpans found;
    for (const Span<double>& span : lists.at(0)) found.push_back({end_from(span.enter), end_from(span.exit)});
    return found;
}

std::optional<FoundEnd> CaseWorld::first_hit() const {
    const Trace trace = trace_ray(bench_, exact_.ray);
    const auto* chosen = trace.rays.at(0).find<BoundaryChosen>();
    if (chosen == nullptr) return std::nullopt;
    FoundEnd end;
    end.t = chosen->boundary.t;
    end.error_bound = chosen->error_bound;
    end.normal = chosen->normal;
    end.flipped = chosen->boundary.flipped;
    end.leaf = leaf_with_name(exact_, trace.generics.at(static_cast<std::size_t>(chosen->boundary.leaf)));
    if (end.leaf != outside_of_list)
        end.face = face_name(exact_.leaves[end.leaf].shape, chosen->boundary.face);
    return end;
}

} // namespace rayscope::test
