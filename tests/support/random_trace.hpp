#pragma once
// Traces made by chance for property tests: valid in form, without a meaning.

#include "core/trace/trace.hpp"

#include <rapidcheck.h>

#include <bit>

namespace rayscope::test {

/// Any double: ordinary, huge, tiny, −0, infinite, not-a-number.
inline double any_double() {
    if (*rc::gen::inRange(0, 4) == 0) return std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    static const std::vector<double> special{
        0.0,         -0.0, 1.0, 0.1, 5e-324, 1.7976931348623157e308, infinity<double>, -infinity<double>,
        not_a_number};
    return *rc::gen::elementOf(special);
}

inline Vec3d any_vector() { return {any_double(), any_double(), any_double()}; }
inline bool any_bool() { return *rc::gen::arbitrary<bool>(); }
inline int any_int() { return *rc::gen::arbitrary<int>(); }
inline int any_below(std::size_t count) { return *rc::gen::inRange(0, int(count)); }
inline int any_below_or_none(std::size_t count) { return *rc::gen::inRange(-1, int(count)); }
inline std::string any_name() {
    return *rc::gen::element<std::string>("", "bowl", "a - b", "\"quoted\\\"", "\xC3\xA9\n", "</script>");
}
inline Boundary any_boundary(const Trace& trace) {
    return {any_double(), any_below_or_none(trace.generics.size()), any_int(), any_bool()};
}

inline Event any_event(const Trace& trace) {
    const auto object = [&] { return any_below(trace.objects.size()); };
    const auto reason = [] { return Reason(any_below(6)); };
    const auto medium = [&] { return any_below_or_none(trace.media.size()); };
    switch (*rc::gen::inRange(0, 22)) {
    case 0: return ObjectAccepted{object(), any_double()};
    case 1: {
        const int id = object();
        return NodeEvaluated{id, any_below(trace.objects[std::size_t(id)].nodes.size()), any_below(4)};
    }
    case 2: return SpanFound{any_boundary(trace), any_boundary(trace)};
    case 3: return ClusterMerged{object(), any_int(), any_double(), any_double(), any_bool()};
    case 4:
        return BoundaryChosen{object(),     any_boundary(trace), any_bool(),   any_double(),
                              any_vector(), any_vector(),        any_vector(), medium(),
                              medium(),     any_double(),        any_double()};
    case 5: return Missed{any_vector()};
    case 6: return AmbientLit{any_vector(), any_vector()};
    case 7:
        return LightLit{any_below(trace.lights.size()),
                        any_vector(),
                        any_double(),
                        any_double(),
                        any_double(),
                        any_int(),
                        any_int(),
                        any_vector(),
                        any_vector(),
                        any_vector(),
                        any_vector(),
                        any_vector(),
                        any_vector()};
    case 8: return LocalLightSkipped{reason()};
    case 9: return BlockerPassed{object(), any_double(), any_vector()};
    case 10: return Reflected{any_vector(), any_double(), any_vector()};
    case 11:
        return Refracted{any_vector(), any_double(), any_double(), any_double(),
                         any_double(), any_vector(), any_double()};
    case 12: return TotallyReflected{any_vector(), any_double(), any_double(), any_double(), any_double()};
    case 13: return NotSpawned{RayKind(any_below(4)), reason(), any_double(), any_vector()};
    case 14: return SearchBegan{StageKind(any_below(6)), any_int()};
    case 15:
        return PlaceEntered{PlaceKind(any_below(7)),
                            any_int(),
                            any_int(),
                            any_below_or_none(trace.objects.size()),
                            any_int(),
                            any_vector(),
                            any_vector(),
                            any_double(),
                            any_double()};
    case 16: return PlaceLeft{any_int(), any_int()};
    case 17:
        return SearchEnded{SearchEnd(any_below(4)), any_double(), any_int(), any_int(), any_int(), any_int()};
    case 18: return Absorbed{medium(), any_double(), any_vector()};
    case 19: return FresnelShared{any_double(), any_double(), any_double(), any_double(), any_double()};
    case 20: return TriangleHit{any_int(), any_int(), any_int(), any_int(), any_vector()};
    default: return RayFinished{any_vector(), any_vector(), any_int(), any_int()};
    }
}

inline TraceObject any_object(const Trace& trace) {
    TraceObject object{any_name(), any_name(), {}};
    const std::size_t count = std::size_t(any_below(5)) + 1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto operation = i == 0 ? Operation::leaf : Operation(any_below(5));
        TraceNode node{operation, none, none, none, any_name()};
        if (operation == Operation::leaf) node.generic = any_below(trace.generics.size());
        if (operation != Operation::leaf) node.left = any_below(i);
        if (operation != Operation::leaf && operation != Operation::complement) node.right = any_below(i);
        object.nodes.push_back(node);
    }
    return object;
}

inline Trace any_trace() {
    Trace trace;
    trace.source = {any_name(), any_bool(), any_int(), any_int(), any_int(), any_double()};
    trace.max_depth = any_int();
    trace.min_weight = any_double();
    trace.eye = any_vector();
    trace.colour = any_vector();
    trace.events_dropped = *rc::gen::arbitrary<std::size_t>();
    for (int i = any_below(3); i >= 0; --i) trace.generics.push_back(any_name());
    for (int i = any_below(3); i >= 0; --i) trace.objects.push_back(any_object(trace));
    for (int i = any_below(3); i >= 0; --i) trace.media.push_back({any_name(), any_double()});
    for (int i = any_below(3); i >= 0; --i) trace.lights.push_back({any_name(), any_bool(), any_vector()});
    const int rays = any_below(6) + 1;
    for (int i = 0; i < rays; ++i) {
        TracedRay ray;
        ray.parent = i == 0 ? none : any_below(std::size_t(i));
        if (i > 0) trace.rays[std::size_t(ray.parent)].children.push_back(i);
        const auto kind = RayKind(any_below(4));
        ray.events.emplace_back(RaySpawned{kind, any_int(), any_vector(), any_vector(), any_vector(),
                                           any_double(), any_below_or_none(trace.media.size()),
                                           kind == RayKind::shadow ? any_below(trace.lights.size()) : none,
                                           any_below_or_none(trace.objects.size()), any_double(),
                                           any_double()});
        for (int n = any_below(8); n > 0; --n) ray.events.push_back(any_event(trace));
        trace.rays.push_back(std::move(ray));
    }
    return trace;
}

} // namespace rayscope::test
