#include "core/stage/record_object.hpp"

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

} // namespace

template <Numbers N, Scalar T>
void record_object(const World<N>& world, std::uint32_t object, const Ray<T>& ray, const Range<T>& range,
                   const LeavingSurface<T>* leaving, TraceRecorder& recorder) {
    Work<T> work; // its counts are not the tracer's
    const Crossings<T> list = crossings(world, object, ray, leaving, work);
    if (world.objects[object].is_compound)
        record_compound(world, object, ray, leaving, recorder);
    else if (!list.empty())
        record_node<T>(object, 0, list, world.objects[object].has_volume, recorder);
    if (const auto first = first_crossing(world, ray, list, range, leaving))
        recorder.record(ObjectAccepted{Id(object), double(first->t)});
}

template void record_object(const World<float>&, std::uint32_t, const Ray<float>&, const Range<float>&,
                            const LeavingSurface<float>*, TraceRecorder&);
template void record_object(const World<Textbook<float>>&, std::uint32_t, const Ray<float>&,
                            const Range<float>&, const LeavingSurface<float>*, TraceRecorder&);
template void record_object(const World<double>&, std::uint32_t, const Ray<double>&, const Range<double>&,
                            const LeavingSurface<double>*, TraceRecorder&);
template void record_object(const World<Textbook<double>>&, std::uint32_t, const Ray<double>&,
                            const Range<double>&, const LeavingSurface<double>*, TraceRecorder&);
template void record_object(const World<long double>&, std::uint32_t, const Ray<long double>&,
                            const Range<long double>&, const LeavingSurface<long double>*, TraceRecorder&);
template void record_object(const World<Textbook<long double>>&, std::uint32_t, const Ray<long double>&,
                            const Range<long double>&, const LeavingSurface<long double>*, TraceRecorder&);
template void record_object(const World<Float128>&, std::uint32_t, const Ray<Float128>&,
                            const Range<Float128>&, const LeavingSurface<Float128>*, TraceRecorder&);
template void record_object(const World<Textbook<Float128>>&, std::uint32_t, const Ray<Float128>&,
                            const Range<Float128>&, const LeavingSurface<Float128>*, TraceRecorder&);

} // namespace rayscope
