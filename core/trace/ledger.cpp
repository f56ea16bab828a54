#include "core/trace/ledger.hpp"

namespace rayscope {
namespace {

/// What media let pass on a ray's own way.
Colour passed_on(const TracedRay& ray) {
    const auto* absorbed = ray.find<Absorbed>();
    return absorbed != nullptr ? absorbed->passed : Colour{1};
}

/// One ray's part. Weights are shares of the pixel at the ray's start.
class Entry {
public:
    /// @param before what media let pass of the way from the eye to the ray's start
    Entry(Ledger& ledger, const TracedRay& ray, const Colour& before)
        : ledger_(ledger), start_(ray.start()), passed_(passed_on(ray)), before_(before) {
        if (const auto* hit = ray.find<BoundaryChosen>()) object_ = hit->object;
    }

    void operator()(const Missed& e) { add(LightKind::background, e.background); }
    void operator()(const AmbientLit& e) { add(LightKind::ambient, e.scene * e.material); }
    void operator()(const LightLit& e) {
        add(LightKind::diffuse, e.diffuse);
        add(LightKind::specular, e.specular);
    }
    void operator()(const NotSpawned& e) {
        if (!(largest_component(e.weight) > 0) || e.reason == Reason::total_internal_reflection) return;
        DroppedRays& dropped = ledger_.dropped[{e.kind, e.reason}];
        ++dropped.count;
        dropped.weight += e.weight;
    }
    void operator()(const auto& /*event*/) {}

    /// What would have come back without absorption on this ray's way, and arrived at the eye without any: so the losses
    /// of the rays that follow each other add up to what all of them lose together.
    void absorb(const RayFinished& end) {
        for (int i = 0; i < 3; ++i)
            if (passed_[i] > 0 && passed_[i] < 1 && before_[i] > 0)
                ledger_.absorbed[i] += start_.weight[i] / before_[i] * end.colour[i] * (1 / passed_[i] - 1);
    }

private:
    void add(LightKind kind, const Colour& light) {
        const Colour arriving = start_.weight * passed_ * light;
        if (largest_component(absolute(arriving)) > 0)
            ledger_.sources[{kind, start_.kind, object_}] += arriving;
        ledger_.total += arriving;
    }

    Ledger& ledger_;
    const RaySpawned& start_;
    Colour passed_, before_;
    Id object_ = none;
};

} // namespace

Ledger ledger_of(const std::vector<TracedRay>& rays) {
    Ledger ledger;
    std::vector<Colour> before(rays.size(), Colour{1}); // parents stand before their children
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const TracedRay& ray = rays[i];
        if (ray.parent != none)
            before[i] = before[std::size_t(ray.parent)] * passed_on(rays[std::size_t(ray.parent)]);
        if (ray.start().kind == RayKind::shadow) continue;
        Entry entry(ledger, ray, before[i]);
        for (const Event& event : ray.events) std::visit(entry, event);
        if (const auto* end = ray.find<RayFinished>()) entry.absorb(*end);
    }
    return ledger;
}

Ledger& operator+=(Ledger& sum, const Ledger& more) {
    for (const auto& [source, light] : more.sources) sum.sources[source] += light;
    for (const auto& [kind, dropped] : more.dropped) {
        sum.dropped[kind].count += dropped.count;
        sum.dropped[kind].weight += dropped.weight;
    }
    sum.absorbed += more.absorbed;
    sum.total += more.total;
    return sum;
}

Ledger& operator/=(Ledger& sum, double parts) {
    for (auto& source : sum.sources) source.second /= parts;
    for (auto& entry : sum.dropped) entry.second.weight /= parts;
    sum.absorbed /= parts;
    sum.total /= parts;
    return sum;
}

} // namespace rayscope
