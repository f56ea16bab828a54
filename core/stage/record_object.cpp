#include "core/stage/record_object.hpp"

#include "core/stage/record_search.hpp"

#include <algorithm>

namespace rayscope {
namespace {

template <Scalar T> using Crossings = std::span<const Crossing<T>>;

template <Scalar T> Boundary boundary_of(const Crossing<T>& crossing) {
    const bool bounded = is_finite(crossing.t);
    return {double(crossing.t), bounded ? Id(crossing.surface.solid) : none, int(crossing.surface.face),
            bounded && crossing.surface.flipped};
}

// A surface without volume is a single crossing: its span has no length.
template <Scalar T>
void record_node(std::uint32_t object, std::size_t node, Crossings<T> list, bool volume,
                 TraceRecorder& recorder) {
    const std::size_t step = volume ? 2 : 1;
    recorder.record(NodeEvaluated{Id(object), Id(node), int(list.size() / step)});
    for (std::size_t i = 0; i < list.size(); i += step)
        recorder.record(SpanFound{boundary_of(list[i]), boundary_of(list[i + step - 1])});
}

template <Numbers N, Scalar T = ScalarOf<N>>
bool line_misses(const World<N>& world, const Compound& compound, const Ray<T>& ray,
                 const LeavingSurface<T>* leaving) {
    Work<T> work;
    work.scratch.push();
    for (const CompoundNode& node : compound.nodes)
        if (node.operation == Operation::leaf) {
            append_crossings(world, node.solid, ray, leaving, work);
            if (work.scratch.top_size() > 0) return false;
        }
    return true;
}

template <Numbers N, Scalar T = ScalarOf<N>>
void record_compound(const World<N>& world, std::uint32_t object, const Ray<T>& ray,
                     const LeavingSurface<T>* leaving, TraceRecorder& recorder) {
    const Compound& compound = world.compounds[world.objects[object].index];
    if (line_misses(world, compound, ray, leaving)) return;
    Work<T> work;
    SpanStack<T>& scratch = work.scratch;
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
            settle(world, ray, scratch, [&](const Cluster<T>& cluster) {
                recorder.record(ClusterMerged{Id(object), cluster.count, double(cluster.first),
                                              double(cluster.last), cluster.kept});
            });
        }
        record_node<T>(object, i, {scratch.top_begin(), scratch.top_size()}, true, recorder);
    }
}

// How many generics a part of a program holds.
int held_by_part(const Program& program, std::uint32_t extent, std::uint32_t end) {
    const auto is_begin = [&](const Instruction& step) {
        return step.kind == Instruction::Kind::extent && step.operand == extent;
    };
    return int(std::count_if(std::find_if(program.begin(), program.end(), is_begin), program.begin() + end,
                             [](const Instruction& step) { return step.kind == Instruction::Kind::leaf; }));
}

// The boxes of parts that the search looks into, in its order.
template <Numbers N, Scalar T = ScalarOf<N>>
void record_parts(const World<N>& world, std::uint32_t object, const Ray<T>& ray,
                  const LeavingSurface<T>* leaving, TraceRecorder& recorder) {
    const Compound& compound = world.compounds[world.objects[object].index];
    if (compound.extents.empty()) return;
    Work<T> work;
    work.tests_parts = true;
    MissedParts<T> misses(compound, ray, leaving, work);
    const SlabRay<T> slabs(ray, T(compound.size), most_distorted<T>,
                           leaving != nullptr ? leaving->beside : T(0));
    const auto push = [&](std::uint32_t solid) { append_crossings(world, solid, ray, leaving, work); };
    run(std::span<const Instruction>(compound.program), work.scratch, push,
        std::span<const PartExtent>(compound.extents), [&](std::uint32_t extent) {
            if (misses(extent)) return true;
            const auto& [box, end] = compound.extents[extent];
            const BoxSpan<T> inside = slabs.span(as<T>(box));
            PlaceEntered entered =
                place_entered(PlaceKind::part, Id(extent), 0, held_by_part(compound.program, extent, end),
                              as<T>(box), inside.enter, inside.exit);
            entered.object = Id(object);
            recorder.record(entered);
            return false;
        });
}

} // namespace

template <Numbers N, Scalar T>
void record_object(const World<N>& world, std::uint32_t object, const Ray<T>& ray, const Range<T>& range,
                   const LeavingSurface<T>* leaving, bool tests_parts, TraceRecorder& recorder) {
    Work<T> work; // its counts are not the tracer's
    if (tests_parts && world.objects[object].is_compound) record_parts(world, object, ray, leaving, recorder);
    const Crossings<T> list = crossings(world, object, ray, leaving, work);
    if (world.objects[object].is_compound)
        record_compound(world, object, ray, leaving, recorder);
    else if (!list.empty())
        record_node<T>(object, 0, list, world.objects[object].has_volume, recorder);
    if (const auto first = first_crossing(world, ray, list, range, leaving))
        recorder.record(ObjectAccepted{Id(object), double(first->t)});
}

template void record_object(const World<float>&, std::uint32_t, const Ray<float>&, const Range<float>&,
                            const LeavingSurface<float>*, bool, TraceRecorder&);
template void record_object(const World<Textbook<float>>&, std::uint32_t, const Ray<float>&,
                            const Range<float>&, const LeavingSurface<float>*, bool, TraceRecorder&);
template void record_object(const World<double>&, std::uint32_t, const Ray<double>&, const Range<double>&,
                            const LeavingSurface<double>*, bool, TraceRecorder&);
template void record_object(const World<Textbook<double>>&, std::uint32_t, const Ray<double>&,
                            const Range<double>&, const LeavingSurface<double>*, bool, TraceRecorder&);
template void record_object(const World<long double>&, std::uint32_t, const Ray<long double>&,
                            const Range<long double>&, const LeavingSurface<long double>*, bool,
                            TraceRecorder&);
template void record_object(const World<Textbook<long double>>&, std::uint32_t, const Ray<long double>&,
                            const Range<long double>&, const LeavingSurface<long double>*, bool,
                            TraceRecorder&);
template void record_object(const World<Float128>&, std::uint32_t, const Ray<Float128>&,
                            const Range<Float128>&, const LeavingSurface<Float128>*, bool, TraceRecorder&);
template void record_object(const World<Textbook<Float128>>&, std::uint32_t, const Ray<Float128>&,
                            const Range<Float128>&, const LeavingSurface<Float128>*, bool, TraceRecorder&);

} // namespace rayscope
