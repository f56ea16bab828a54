#include "core/substitute/hooks.hpp"

#include <algorithm>

namespace rayscope {
namespace {

using Crossings = std::vector<Crossing<double>>;

std::vector<FormulaHit> hits_of(const World<Substituted>& world, const Ray<double>& ray,
                                const Crossings& list, int first) {
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
Crossings list_of(std::vector<FormulaHit> hits, const std::vector<FormulaHit>& given,
                  const Crossings& sources) {
    std::stable_sort(hits.begin(), hits.end(),
                     [](const FormulaHit& a, const FormulaHit& b) { return a.t < b.t; });
    Crossings list;
    for (const FormulaHit& hit : hits) {
        const auto from = std::find_if(given.begin(), given.end(),
                                       [&](const FormulaHit& one) { return one.source == hit.source; });
        if (from == given.end() || !is_finite(hit.t)) continue;
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

Crossings difference(const World<Substituted>& world, const Ray<double>& ray, const Crossings& a,
                     const Crossings& b) {
    auto of_a = hits_of(world, ray, a, 0);
    const auto of_b = hits_of(world, ray, b, int(a.size()));
    const auto hits = formulas_in_use().formulas->difference(of_a, of_b);
    Crossings sources = a;
    sources.insert(sources.end(), b.begin(), b.end());
    of_a.insert(of_a.end(), of_b.begin(), of_b.end());
    return list_of(hits, of_a, sources);
}

/// One operation by the sweep.
Crossings combined(Operation operation, const Crossings& a, const Crossings* b) {
    SpanStack<double> stack;
    for (const Crossings* list : {&a, b}) {
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

Crossings compound(const World<Substituted>& world, const Program& program, const Ray<double>& ray,
                   const LeavingSurface<double>* leaving, Work<double>& work) {
    std::vector<Crossings> stack;
    for (const Instruction& step : program) {
        if (step.kind == Instruction::Kind::guard) continue; // it only saves work
        if (step.kind == Instruction::Kind::leaf) {
            work.scratch.clear();
            work.scratch.push();
            append_crossings(world, step.operand, ray, leaving, work);
            stack.emplace_back(work.scratch.top_begin(), work.scratch.top_begin() + work.scratch.top_size());
            work.of_operands.insert(work.of_operands.end(), stack.back().begin(), stack.back().end());
        } else if (step.kind == Instruction::Kind::complement) {
            stack.back() = combined(step.operation, stack.back(), nullptr);
        } else {
            const Crossings b = std::move(stack.back());
            stack.pop_back();
            Crossings& a = stack.back();
            a = step.operation == Operation::difference ? difference(world, ray, a, b)
                                                        : combined(step.operation, a, &b);
        }
    }
    return stack.back();
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
    Crossings list;
    if (o.is_compound) {
        ++work.counters.compounds;
        if (formulas_in_use().formulas->difference)
            list = compound(world, world.compounds[o.index].program, ray, leaving, work);
        else
            run(std::span<const Instruction>(world.compounds[o.index].program), work.scratch,
                [&](std::uint32_t solid) {
                    append_crossings(world, solid, ray, leaving, work);
                    work.of_operands.insert(work.of_operands.end(), work.scratch.top_begin(),
                                            work.scratch.top_begin() + work.scratch.top_size());
                });
    } else {
        work.scratch.clear();
        work.scratch.push();
        append_crossings(world, o.index, ray, leaving, work);
    }
    if (o.is_compound && formulas_in_use().formulas->difference) {
        work.scratch.clear();
        work.scratch.push();
        for (const Crossing<double>& crossing : list) work.scratch.append(crossing);
    }
    if (o.is_compound) settle(world, ray, work.scratch, unrecorded);
    return {work.scratch.top_begin(), work.scratch.top_size()};
}

} // namespace rayscope
