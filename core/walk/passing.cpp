#include "core/walk/passing.hpp"

#include "core/math/transform.hpp"
#include "core/scene/expand.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr int samples = 128, refinements = 48;

/// The least value along the line: looked for in steps, since a torus has two, then by the golden section.
Passing passing(const Scene& scene, std::size_t index, const Mat4d& matrix, const Ray<double>& ray) {
    const Generic<double>& shape = scene.generics[index].shape;
    const Ray<double> own = Transform<double>(matrix).to_object(ray);
    const auto value = [&](double t) { return implicit_value(shape, own.at(t)); };
    const double speed = length(own.direction);
    const double middle = -dot(own.origin, own.direction) / (speed * speed);
    double reach = 4; // shapes lie within this of their origin; a mesh may not
    if (const auto* mesh = std::get_if<Mesh<double>>(&shape))
        reach += length(absolute(mesh->bounds().low)) + length(absolute(mesh->bounds().high));
    const double half = reach / speed, step = 2 * half / samples;
    double best = middle;
    for (int i = 0; i <= samples; ++i)
        if (const double t = middle - half + i * step; value(t) < value(best)) best = t;
    double low = best - step, high = best + step;
    const double golden = (std::sqrt(5.0) - 1) / 2;
    for (int i = 0; i < refinements; ++i) {
        const double a = high - golden * (high - low), b = low + golden * (high - low);
        (value(a) < value(b) ? high : low) = value(a) < value(b) ? b : a;
    }
    const double t = (low + high) / 2;
    return {index, t, value(t)};
}

} // namespace

std::vector<Passing> passings(const Scene& scene, std::size_t drawn, const Ray<double>& ray,
                              std::size_t most) {
    std::vector<Passing> found;
    const auto add = [&](std::size_t generic, const Mat4d& matrix) {
        if (found.size() < most && is_solid(scene.generics[generic].shape))
            found.push_back(passing(scene, generic, matrix, ray));
    };
    const SceneObject& object = scene.drawn[drawn];
    if (!object.is_compound)
        add(object.index, scene.generics[object.index].matrix);
    else
        for (const ExpandedNode& node : expand(scene, object.index))
            if (node.operation == Operation::leaf) add(node.generic, node.matrix);
    return found;
}

} // namespace rayscope
