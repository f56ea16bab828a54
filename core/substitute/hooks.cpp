#include "core/substitute/hooks.hpp"

#include <algorithm>

namespace rayscope {
namespace {

using CrossingList = std::vector<Crossing<double>>;

std::vector<FormulaHit> hits_of(const World<Substituted>& world, const Ray<double>& ray,
                                const CrossingList& list, int first) {
    std::vector<FormulaHit> hits;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const Crossing<double>& crossing = list[i];
        if (!is_finite(crossing.t)) continue;
        const Vec3d normal =
            world.solids[crossing.surface.solid].normal(ray, crossing.t, crossing.surface.face);
        hits.push_back(
            {crossing.t, crossing.surface.flipped ? -normal : normal, crossing.entering, first + int(i)});
    }
    return hits;
}

/// As the sweep would leave it: ascending, entering and leaving in turn, open ends at infinity. What breaks that is left
/// out, so that the picture shows what remains.
CrossingList list_of(std::vector<FormulaHit> hits, const std::vector<FormulaHit>& given,
                     const CrossingList& sources) {
    std::erase_if(hits, [](const FormulaHit& hit) { return !is_finite(hit.t); });
    std::sort(hits.begin(), hits.end(), [](const FormulaHit& x, const FormulaHit& y) {
        return std::pair(x.t, x.source) < std::pair(y.t, y.source);
    });
    CrossingList list;
    for (const FormulaHit& hit : hits) {
        const auto from = std::find_if(given.begin(), given.end(),
                                       [&](const FormulaHit& one) { return one.source == hit.source; });
        if (from == given.end()) continue;
        if (list.empty() && !hit.entering) list.push_back({-infinity<double>, {}, true});
        if (!list.empty() && list.back().entering == hit.entering) continue;
        Crossing<double> crossing = sources[std::size_t(hit.source)];
        crossing.t = hit.t;
        crossing.entering = hit.entering;
        if (dot(from->normal, hit.normal) < 0) crossing.surface.flipped = !crossing.surface.flipped;
        list.push_back(crossing);
    }
    if (!list.empty() && list.back().entering) list.push_back({infinity<double>, {}, false});
    return list;
}

CrossingList difference(const World<Substituted>& world, const Ray<double>& ray, const CrossingList& a,
                        const CrossingList& b) {
    auto of_a = hits_of(world, ray, a, 0);
    const auto of_b = hits_of(world, ray, b, int(a.size()));
    const auto hits = formulas_in_use().formulas->difference(of_a, of_b);
    CrossingList sources = a;
    sources.insert(sources.end(), b.begin(), b.end());
    of_a.insert(of_a.end(), of_b.begin(), of_b.end());
    return list_of(hits, of_a, sources);
}

/// One operation by the sweep.
CrossingList combined(Operation operation, const CrossingList& a, const CrossingList* b) {
    SpanStack<double> stack;
    for (const CrossingList* list : {&a, b}) {
        if (list == nullptr) continue;
        stack.push();
        for (const Crossing<double>& crossing : *list) stack.append(crossing);
    }
    if (b == nullptr)
        stack.complement();
    else
        stack.combine(operation);
    return {stack.top_begin(), stack.top_begin() + stack.top_size()};
}

/// A and B are on top of the stack; what the operation makes of them replaces them.
void combine_top(const World<Substituted>& world, const Ray<double>& ray, Operation operation,
                 std::vector<CrossingList>& stack) {
    if (operation == Operation::complement) {
        stack.back() = combined(operation, stack.back(), nullptr);
        return;
    }
    const CrossingList b = std::move(stack.back());
    stack.pop_back();
    CrossingList& a = stack.back();
    const bool theirs = operation == Operation::difference && formulas_in_use().formulas->difference;
    a = theirs ? difference(world, ray, a, b) : combined(operation, a, &b);
}

CrossingList leaf(const World<Substituted>& world, std::uint32_t solid, const Ray<double>& ray,
                  const LeavingSurface<double>* leaving, Work<double>& work) {
    work.scratch.clear();
    work.scratch.push();
    append_crossings(world, solid, ray, leaving, work);
    return {work.scratch.top_begin(), work.scratch.top_begin() + work.scratch.top_size()};
}

CrossingList compound(const World<Substituted>& world, const Program& program, const Ray<double>& ray,
                      const LeavingSurface<double>* leaving, Work<double>& work) {
    std::vector<CrossingList> stack;
    for (const Instruction& step : program) {
        if (step.kind == Instruction::Kind::guard || step.kind == Instruction::Kind::extent)
            continue; // they only save work
        if (step.kind == Instruction::Kind::leaf) {
            stack.push_back(leaf(world, step.operand, ray, leaving, work));
            note_ends(work); // which leaf() has left on the scratch
        } else {
            const bool complement = step.kind == Instruction::Kind::complement;
            combine_top(world, ray, complement ? Operation::complement : step.operation, stack);
        }
    }
    return stack.back();
}

void put_back(const CrossingList& list, SpanStack<double>& scratch) {
    scratch.clear();
    scratch.push();
    for (const Crossing<double>& crossing : list) scratch.append(crossing);
}

Boundary boundary_of(const Crossing<double>& crossing) {
    const bool bounded = is_finite(crossing.t);
    return {crossing.t, bounded ? Id(crossing.surface.solid) : none, int(crossing.surface.face),
            bounded && crossing.surface.flipped};
}

void record_list(std::uint32_t object, std::size_t node, const CrossingList& list, bool volume,
                 TraceRecorder& recorder) {
    const std::size_t step = volume ? 2 : 1;
    recorder.record(NodeEvaluated{Id(object), Id(node), int(list.size() / step)});
    for (std::size_t i = 0; i + step <= list.size(); i += step)
        recorder.record(SpanFound{boundary_of(list[i]), boundary_of(list[i + step - 1])});
}

/// Node by node of the author's tree; nothing if the line misses all of its generics.
void record_nodes(const World<Substituted>& world, std::uint32_t object, const Ray<double>& ray,
                  const LeavingSurface<double>* leaving, TraceRecorder& recorder) {
    const Compound& tree = world.compounds[world.objects[object].index];
    Work<double> work;
    bool misses = true;
    for (const CompoundNode& node : tree.nodes)
        misses = misses &&
                 (node.operation != Operation::leaf || leaf(world, node.solid, ray, leaving, work).empty());
    if (misses) return;
    std::vector<CrossingList> stack;
    for (std::size_t i = 0; i < tree.nodes.size() && !recorder.full(); ++i) {
        const CompoundNode& node = tree.nodes[i];
        if (node.operation == Operation::leaf)
            stack.push_back(leaf(world, node.solid, ray, leaving, work));
        else
            combine_top(world, ray, node.operation, stack);
        if (i + 1 == tree.nodes.size()) {
            put_back(stack.back(), work.scratch);
            settle(world, ray, work.scratch, [&](const Cluster<double>& cluster) {
                recorder.record(
                    ClusterMerged{Id(object), cluster.count, cluster.first, cluster.last, cluster.kept});
            });
            stack.back().assign(work.scratch.top_begin(), work.scratch.top_begin() + work.scratch.top_size());
        }
        record_list(object, i, stack.back(), true, recorder);
    }
}

} // namespace

FormulasInUse& formulas_in_use() {
    static FormulasInUse use;
    return use;
}

template <> Vec3<double> Solid<Substituted>::normal(const Ray<double>& ray, double t, int face) const {
    FormulasInUse& use = formulas_in_use();
    use.hit_point = ray.at(t);
    const Vec3d p = transform.to_object(ray).at(t);
    const Vec3d n = std::visit([&](const auto& s) { return s.normal(p, face); }, shape);
    if (!use.formulas->normal) return transform.normal_to_world(n);
    return use.formulas->normal(normalized(n), transform.matrix());
}

template <> Intervals<double> Solid<Substituted>::intervals(const Ray<double>& ray, int leaving) const {
    const Formulas& formulas = *formulas_in_use().formulas;
    const Ray<double> moved =
        formulas.to_object ? formulas.to_object(ray, transform.matrix()) : transform.to_object(ray);
    return std::visit([&](const auto& s) { return s.intervals(moved, leaving); }, shape);
}

template <> void reconsider_wall<Substituted>(const World<Substituted>& world, Interaction<Substituted>& at) {
    FormulasInUse& use = formulas_in_use();
    use.wall.reset();
    const bool enters = at.hit.entering;
    const Id inside = enters ? at.media.to : at.media.from, outside = enters ? at.media.from : at.media.to;
    const bool in_air = outside == none && world.medium_speed == 1;
    if (!use.formulas->wall || inside != Id(at.hit.object) || !in_air) return;
    use.wall = use.formulas->wall(at.incoming, at.normal, speed_in(world, inside));
    at.facing = at.flat = use.wall->facing;
    at.speed_from = use.wall->speed_from;
    at.speed_to = use.wall->speed_to;
    at.leaves_transmitting_solid = !use.wall->local;
}

template <> Intervals<double> Sphere<Substituted>::intervals(const Ray<double>& ray, int leaving) const {
    const Formulas& formulas = *formulas_in_use().formulas;
    if (!formulas.sphere) return Sphere<double>{radius}.intervals(ray, leaving);
    const auto spans = formulas.sphere({ray.origin / radius, ray.direction / radius});
    if (spans.empty()) return {};
    Interval<double> inside{spans.front().first, spans.front().second, 0, 0};
    // The ray starts on the sphere: of both ends the nearer one is its start.
    if (leaving == 0) (magnitude(inside.enter) < magnitude(inside.exit) ? inside.enter : inside.exit) = 0;
    return Intervals<double>(inside);
}

template <>
std::span<const Crossing<double>>
crossings<Substituted, double>(const World<Substituted>& world, std::uint32_t object, const Ray<double>& ray,
                               const LeavingSurface<double>* leaving, Work<double>& work) {
    const Object& o = world.objects[object];
    ++work.counters.objects;
    work.of_operands.clear();
    if (!o.is_compound) {
        put_back(leaf(world, o.index, ray, leaving, work), work.scratch);
    } else {
        ++work.counters.compounds;
        put_back(compound(world, world.compounds[o.index].program, ray, leaving, work), work.scratch);
        settle(world, ray, work.scratch, unrecorded);
    }
    return {work.scratch.top_begin(), work.scratch.top_size()};
}

template <>
void record_object<Substituted, double>(const World<Substituted>& world, std::uint32_t object,
                                        const Ray<double>& ray, const Range<double>& range,
                                        const LeavingSurface<double>* leaving, bool /*tests_parts*/,
                                        TraceRecorder& recorder) {
    Work<double> work;
    const auto found = crossings(world, object, ray, leaving, work);
    const CrossingList list(found.begin(), found.end());
    if (world.objects[object].is_compound)
        record_nodes(world, object, ray, leaving, recorder);
    else if (!list.empty())
        record_list(object, 0, list, world.objects[object].has_volume, recorder);
    if (const auto first = first_crossing(world, ray, found, range, leaving))
        recorder.record(ObjectAccepted{Id(object), first->t});
}

} // namespace rayscope
