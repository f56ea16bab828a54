#include "tests/oracle/case_world.hpp"

#include "core/cases/case_scene.hpp"
#include "core/scene/build.hpp"

#include <array>

namespace rayscope::test {
namespace {

constexpr std::size_t outside_of_list = static_cast<std::size_t>(-1);

std::string leaf_name(std::size_t leaf) { return "leaf" + std::to_string(leaf); }

// A material for each leaf, by whose shininess its walls are recognized in the world.
Scene marked_scene(const LineCase& exact) {
    Scene scene = scene_of(exact);
    scene.materials.assign(exact.leaves.size(), {});
    for (std::size_t i = 0; i < exact.leaves.size(); ++i) {
        scene.materials[i].name = "of_" + leaf_name(i);
        scene.materials[i].shininess = static_cast<double>(i + 1);
        scene.generics[i].material = i;
    }
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

CaseWorld::CaseWorld(const LineCase& exact, NumbersChoice numbers)
    : exact_(exact), numbers_(numbers), bench_(make_workbench(marked_scene(exact))) {}

FoundEnd CaseWorld::found(const SpanEnd& end) const {
    FoundEnd result;
    result.t = static_cast<double>(end.t);
    if (!std::isfinite(result.t)) return result;
    const Solid<double>& solid = bench_.world.solids.at(end.surface.solid);
    result.t_rest = static_cast<double>(end.t - static_cast<Float128>(result.t));
    result.leaf = static_cast<std::size_t>(bench_.world.materials.at(solid.material).shininess) - 1;
    result.face = face_name(solid.shape, end.surface.face);
    result.flipped = end.surface.flipped;
    result.error_bound = end.error_bound;
    result.normal = end.normal;
    return result;
}

FoundSpans CaseWorld::spans() const {
    return with_numbers(numbers_, [&]<Numbers N>() {
        const World<N> world = build<N>(bench_.scene);
        FoundSpans result;
        for (const ObjectSpan& span : object_spans(world, 0, as<ScalarOf<N>>(exact_.ray)))
            result.push_back({found(span.enter), found(span.exit)});
        return result;
    });
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
