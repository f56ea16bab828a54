#pragma once
// The events that need more than their arguments.

#include "core/trace/recorder.hpp"
#include "core/tracer/budget.hpp"
#include "core/tracer/interaction.hpp"

namespace rayscope {

template <Scalar T>
[[nodiscard]] RaySpawned spawned(RayKind kind, const Ray<T>& ray, const Leaving<T>& leaving,
                                 const Budget& budget, T reach = infinity<T>, Id light = none) {
    RaySpawned event{
        kind,          budget.depth,      budget.weight, as<double>(ray.origin), as<double>(ray.direction),
        double(reach), Id(budget.medium), light};
    if (leaving.count > 0) {
        event.left_object = Id(leaving.items[0].object);
        event.left_bound = double(leaving.items[0].bound);
    }
    event.wavelength = double(budget.wavelength);
    return event;
}

template <Numbers N> [[nodiscard]] BoundaryChosen boundary_chosen(const Interaction<N>& at) {
    const Surface& surface = at.hit.surface;
    return {Id(at.hit.object),     {double(at.hit.t), Id(surface.solid), int(surface.face), surface.flipped},
            at.hit.entering,       double(at.error_bound),
            as<double>(at.point),  as<double>(at.normal),
            as<double>(at.facing), Id(at.media.from),
            Id(at.media.to),       double(at.speed_from),
            double(at.speed_to)};
}

/// Nothing where no mesh was hit.
template <Numbers N, Scalar T = ScalarOf<N>>
[[nodiscard]] std::optional<TriangleHit> triangle_hit(const World<N>& world, const Ray<T>& ray,
                                                      const Hit<T>& hit) {
    const Solid<N>& solid = world.solids[hit.surface.solid];
    const auto* mesh = std::get_if<Mesh<N>>(&solid.shape);
    if (mesh == nullptr) return std::nullopt;
    const int triangle = int(hit.surface.face);
    const MeshData& data = mesh->triangles().data();
    const auto corner = [&](std::size_t i) {
        return int(data.triangles[std::size_t(triangle)][i]) + data.first_number;
    };
    const Vec3<T> p = solid.transform.to_object(ray).at(hit.t);
    return TriangleHit{triangle, corner(0), corner(1), corner(2), as<double>(mesh->barycentric(p, triangle))};
}

} // namespace rayscope
