#include "core/extents/record_object.hpp"

namespace rayscope {
namespace {

using Crossings = std::span<const Crossing<double>>;

Boundary boundary_of(const Crossing<double>& crossing) {
    const bool bounded = std::isfinite(crossing.t);
    return {crossing.t, bounded ? Id(crossing.surface.solid) : none, int(crossing.surface.face),
            bounded && crossing.surface.flipped};
}

// A surface without volume is a single crossing: its span has no length.
void record_node(std::uint32_t object, std::size_t node, Crossings list, bool volume,
                 TraceRecorder& recorder) {
    const std::size_t step = volume ? 2 : 1;
    recorder.record(NodeEvaluated{Id(object), Id(node), int(list.size() / step)});
    for (std::size_t i = 0; i < list.size(); i += step)
        recorder.record(SpanFound{boundary_of(list[i]), boundary_of(list[i + step - 1])});
}

bool line_misses(const World<double>& world, const Compound& compound, const Ray<double>& ray,
                 const LeavingSurface<double>* leaving) {
    for (const CompoundNode& node : compound.nodes)
        if (node.operation == Operation::leaf &&
            world.solids[node.solid]
                    .intervals(ray, leaving != nullptr ? leaving->face_of(node.solid) : no_face)
                    .count > 0)
            return false;
    return true;
}

void record_compound(const World<double>& world, std::uint32_t object, const Ray<double>& ray,
                     const LeavingSurface<double>* leaving, TraceRecorder& recorder) {
    const Compound& compound = world.compounds[world.objects[object].index];
    if (line_misses(world, compound, ray, leaving)) return;
    Work<double> work;
    SpanStack<double>& scratch = work.scratch;
    for (std::size_t i = 0; i < compound.nodes.size() && !recorder.full(); ++i) {
        const CompoundNode& node = compound.nodes[i];
        if (node.operation == Operation::leaf) {
            scratch.push();
            append_crossings(world, node.solid, ray, leaving, work);
        } else if (node.operation == Operation::complement) {
            scratch.complement();
        } else {
            scratch.combine(node.operation);
        }
        if (i + 1 == compound.nodes.size()) {
            settle(world, ray, scratch, [&](const Cluster<double>& cluster) {
                recorder.record(
                    ClusterMerged{Id(object), cluster.count, cluster.first, cluster.last, cluster.kept});
            });
        }
        record_node(object, i, {scratch.top_begin(), scratch.top_size()}, true, recorder);
    }
}

} // namespace

void record_object(const World<double>& world, std::uint32_t object, const Ray<double>& ray,
                   const Range<double>& range, const LeavingSurface<double>* leaving,
                   TraceRecorder& recorder) {
    Work<double> work; // its counts are not the tracer's
    const Crossings list = crossings(world, object, ray, leaving, work);
    if (world.objects[object].is_compound)
        record_compound(world, object, ray, leaving, recorder);
    else if (!list.empty())
        record_node(object, 0, list, world.objects[object].has_volume, recorder);
    if (const auto first = first_crossing(world, ray, list, range, leaving))
        recorder.record(ObjectAccepted{Id(object), first->t});
}

} // namespace rayscope
