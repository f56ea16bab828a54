#include "core/trace/divergence.hpp"

#include "core/trace/children.hpp"
#include "core/trace/events_of.hpp"
#include "core/trace/explained.hpp"
#include "core/trace/given.hpp"
#include "core/trace/span_counts.hpp"

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

/// Why none of this kind follows; nothing if one does, or should.
std::optional<Reason> refusal(const TracedRay& ray, RayKind kind) {
    for (const NotSpawned* refused : events_of<NotSpawned>(ray))
        if (refused->kind == kind) return refused->reason;
    return std::nullopt;
}

/// The largest component of |a − b|; NaN if one is, which largest_component() would pass over.
double distance(const Vec3d& a, const Vec3d& b) {
    double largest = 0;
    for (int i = 0; i < 3; ++i) {
        const double d = magnitude(a[i] - b[i]);
        if (std::isnan(d)) return d;
        largest = maximum(largest, d);
    }
    return largest;
}

class SideBySide {
public:
    SideBySide(const Trace& a, const Trace& b, Precision of_a, Precision of_b)
        : a_(a), b_(b), of_a_(of_a), of_b_(of_b), epsilon_(std::max(of_a.epsilon, of_b.epsilon)) {}

    Comparison compared() {
        (void)ray(0);
        return std::move(result_);
    }

private:
    // Each part answers whether the walk goes on.

    bool ray(int index) {
        if (std::size_t(index) >= b_.rays.size()) return result_.complete = false;
        const TracedRay &a = a_.rays[std::size_t(index)], &b = b_.rays[std::size_t(index)];
        index_ = index;
        ++result_.rays;
        if (!complete(a) || !complete(b) || !start(a, b) || !spans(a, b)) return false;
        if (a.start().kind == RayKind::shadow) return visibility(a, b);
        if (!hit(a, b) || !given(a, b)) return false;
        if (has_event<Missed>(a)) return true;
        const Drift drift = drift_at_hit(a, b);
        return local_light(index, drift) && total(a, b) && shares(a, b, drift) &&
               follow(index, RayKind::reflected, drift) && follow(index, RayKind::refracted, drift);
    }

    bool start(const TracedRay& a, const TracedRay& b) {
        const RaySpawned &p = a.start(), &q = b.start();
        if (medium(a_, p.medium) != medium(b_, q.medium)) return differs({Answer::media, index_});
        if (!numbers(Answer::weight, p.weight, q.weight, explained_weight(index_))) return false;
        if (index_ == 0) // given in doubles, and rounded once
            return numbers(Answer::origin, p.origin, q.origin, epsilon_ * length(p.origin)) &&
                   numbers(Answer::direction, p.direction, q.direction, epsilon_ * length(p.direction));
        if (p.kind != RayKind::shadow) return true; // its direction was its parent's answer
        Drift drift;
        drift.point = length(p.origin - q.origin);
        return numbers(Answer::direction, p.direction, q.direction,
                       explained_to_light(a_.lights[std::size_t(p.light)], p.origin, drift, epsilon_),
                       RayKind::shadow);
    }

    bool spans(const TracedRay& a, const TracedRay& b) {
        const auto found = first_span_difference(a_, a, b_, b);
        if (!found) return true;
        Difference d{Answer::spans, index_};
        d.object = found->object;
        d.node = found->node;
        d.first.x = found->first;
        d.second.x = found->second;
        return differs(std::move(d));
    }

    bool visibility(const TracedRay& a, const TracedRay& b) {
        const Colour seen_a = a.find<RayFinished>()->colour, seen_b = b.find<RayFinished>()->colour;
        // A product for each boundary, in doubles; rounding may have turned their order.
        const double rounded = double(events_of<BlockerPassed>(a).size()) * epsilon<double>;
        const double explained = seen_b == Colour{0} ? 0 : rounded + explained_factors(a, b, epsilon_);
        return numbers(Answer::visibility, seen_a, seen_b, explained);
    }

    // Of a ray that was sent on: what its parent's weight and the factors on its way to here brought along.
    [[nodiscard]] double explained_weight(int index) const {
        const int parent = a_.rays[std::size_t(index)].parent;
        if (parent == none) return 0;
        const TracedRay &a = a_.rays[std::size_t(parent)], &b = b_.rays[std::size_t(parent)];
        const double rounded = a.start().weight == b.start().weight ? 0 : 8 * epsilon<double>;
        return rounded + distance(a.start().weight, b.start().weight) + explained_factors(a, b, epsilon_);
    }

    bool hit(const TracedRay& a, const TracedRay& b) {
        if (has_event<Missed>(a) != has_event<Missed>(b)) return differs({Answer::hit, index_});
        if (has_event<Missed>(a)) return true;
        const BoundaryChosen &p = *a.find<BoundaryChosen>(), &q = *b.find<BoundaryChosen>();
        const auto object = [](const Trace& trace, Id id) { return trace.objects[std::size_t(id)].name; };
        if (object(a_, p.object) != object(b_, q.object)) return differs({Answer::object, index_});
        const auto surface = [](const Trace& trace, const Boundary& at) {
            return std::tuple(at.leaf == none ? "" : trace.generics[std::size_t(at.leaf)], at.face,
                              at.flipped);
        };
        if (surface(a_, p.boundary) != surface(b_, q.boundary)) return differs({Answer::face, index_});
        if (p.entering != q.entering) return differs({Answer::side, index_});
        if (medium(a_, p.medium_from) != medium(b_, q.medium_from) ||
            medium(a_, p.medium_to) != medium(b_, q.medium_to))
            return differs({Answer::media, index_});
        const Drift drift = drift_of(a.start(), b.start());
        Difference t{Answer::t, index_};
        t.first.x = p.boundary.t;
        t.second.x = q.boundary.t;
        t.bounds = bounds_of_t(p, q, of_a_.epsilon, of_b_.epsilon);
        t.explained = explained_t(p, a.start(), drift, t.bounds);
        return judged(std::move(t), magnitude(p.boundary.t)) &&
               numbers(Answer::normal, p.normal, q.normal, infinity<double>);
    }

    // Not calculated: the same in all numbers, and another only where the scene is.
    bool given(const TracedRay& a, const TracedRay& b) {
        const auto found = first_given_difference(a, b);
        if (!found) return true;
        Difference d{Answer::given, index_};
        d.what = found->what;
        d.light = found->light;
        d.first = found->first;
        d.second = found->second;
        d.is_vector = true;
        return differs(std::move(d));
    }

    [[nodiscard]] static Drift drift_at_hit(const TracedRay& a, const TracedRay& b) {
        Drift drift = drift_of(a.start(), b.start());
        const BoundaryChosen &p = *a.find<BoundaryChosen>(), &q = *b.find<BoundaryChosen>();
        drift.normal = length(p.normal - q.normal);
        drift.point = length(p.point - q.point);
        return drift;
    }

    bool local_light(int index, const Drift& drift) {
        const TracedRay &a = a_.rays[std::size_t(index)], &b = b_.rays[std::size_t(index)];
        if (has_event<LocalLightSkipped>(a) != has_event<LocalLightSkipped>(b))
            return differs({Answer::local_light, index});
        const auto in_a = events_of<LightLit>(a), in_b = events_of<LightLit>(b);
        for (std::size_t i = 0; i < std::min(in_a.size(), in_b.size()); ++i) {
            const LightLit &p = *in_a[i], &q = *in_b[i];
            const int ray_a = shadow_ray_of(a_, a, p), ray_b = shadow_ray_of(b_, b, q, ray_a);
            Difference asked{Answer::shadow_ray, index};
            asked.light = p.light;
            if ((ray_a == none) != (ray_b == none)) return differs(std::move(asked));
            if (ray_a != none && !ray(ray_a)) return false;
            index_ = index;
            const double turned = drift.normal + length(p.to_light - q.to_light);
            if (!number(Answer::cosine, p.cosine, q.cosine, turned + 4 * epsilon_, p.light) ||
                !number(Answer::mirror_cosine, p.mirror_cosine, q.mirror_cosine,
                        drift.turn + 4 * turned + 8 * epsilon_, p.light))
                return false;
        }
        return true;
    }

    bool total(const TracedRay& a, const TracedRay& b) {
        return has_event<TotallyReflected>(a) == has_event<TotallyReflected>(b) ||
               differs({Answer::total, index_});
    }

    // Fresnel's, which are calculated. Others the scene gives.
    bool shares(const TracedRay& a, const TracedRay& b, const Drift& drift) {
        if (!has_calculated_shares(a, b)) return true;
        const double explained = explained_share(a, drift, epsilon_);
        const auto *mirrored_a = a.find<Reflected>(), *mirrored_b = b.find<Reflected>();
        if (mirrored_a != nullptr && mirrored_b != nullptr &&
            !numbers(Answer::share, mirrored_a->coefficient, mirrored_b->coefficient, explained,
                     RayKind::reflected))
            return false;
        const auto bent_a = events_of<Refracted>(a), bent_b = events_of<Refracted>(b);
        for (std::size_t i = 0; i < std::min(bent_a.size(), bent_b.size()); ++i)
            if (!numbers(Answer::share, bent_a[i]->coefficient, bent_b[i]->coefficient, explained,
                         RayKind::refracted))
                return false;
        return true;
    }

    bool follow(int index, RayKind kind, const Drift& drift) {
        const TracedRay &a = a_.rays[std::size_t(index)], &b = b_.rays[std::size_t(index)];
        if (refusal(a, kind) != refusal(b, kind)) {
            Difference d{Answer::followed, index};
            d.next = kind;
            return differs(std::move(d));
        }
        const auto next_a = children_of(a_, a, kind), next_b = children_of(b_, b, kind);
        if (next_a.size() != next_b.size()) return result_.complete = false;
        const auto bent = events_of<Refracted>(a);
        for (std::size_t i = 0; i < next_a.size(); ++i) {
            const double explained = kind == RayKind::refracted ? explained_bent(*bent[i], drift, epsilon_)
                                                                : explained_mirrored(drift, epsilon_);
            const Vec3d to_a = a_.rays[std::size_t(next_a[i])].start().direction;
            const Vec3d to_b = b_.rays[std::size_t(next_b[i])].start().direction;
            if (!numbers(Answer::direction, to_a, to_b, explained, kind) || !ray(next_a[i])) return false;
            index_ = index;
        }
        return true;
    }

    [[nodiscard]] static std::string_view medium(const Trace& trace, Id id) {
        return id == none ? std::string_view() : trace.media[std::size_t(id)].name;
    }

    // Beyond the cap on events nothing is known.
    bool complete(const TracedRay& ray) {
        const bool answered =
            ray.start().kind == RayKind::shadow || has_event<Missed>(ray) || has_event<BoundaryChosen>(ray);
        return result_.complete = answered && has_event<RayFinished>(ray) && !has_event<Truncated>(ray);
    }

    bool differs(Difference found) {
        found.size = distance(found.first, found.second);
        result_.divergence = std::move(found);
        return false;
    }

    bool numbers(Answer answer, const Vec3d& a, const Vec3d& b, double explained, RayKind of = RayKind::eye) {
        Difference d{answer, index_, of};
        d.first = a;
        d.second = b;
        d.is_vector = true;
        d.explained = explained;
        return judged(std::move(d), largest_component(absolute(a)));
    }

    // A cosine is rounded as its terms are, whose size is 1.
    bool number(Answer answer, double a, double b, double explained, Id light) {
        Difference d{answer, index_, RayKind::eye, light};
        d.first.x = a;
        d.second.x = b;
        d.explained = explained;
        return judged(std::move(d), 1);
    }

    bool judged(Difference d, double size) {
        const Precision& narrower = of_a_.epsilon < of_b_.epsilon ? of_b_ : of_a_;
        d.size = distance(d.first, d.second);
        d.ulps = in_ulps(d.size, size, narrower);
        if (!(d.size <= d.explained + narrower.least)) return differs(std::move(d));
        if (!result_.largest || d.ulps > result_.largest->ulps) result_.largest = std::move(d);
        return true;
    }

    const Trace &a_, &b_;
    Precision of_a_, of_b_;
    double epsilon_;
    int index_ = 0; // of the ray that is compared
    Comparison result_;
};

} // namespace

Comparison compare(const Trace& first, const Trace& second, Precision of_first, Precision of_second) {
    return SideBySide(first, second, of_first, of_second).compared();
}

} // namespace rayscope
