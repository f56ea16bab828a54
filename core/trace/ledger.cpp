#include "core/trace/ledger.hpp"

namespace rayscope {
namespace {

/// One ray's part. Weights are shares of the pixel at the ray's start.
class Entry {
public:
    Entry(Ledger& ledger, const TracedRay& ray) : ledger_(ledger), start_(ray.start()) {
        if (const auto* absorbed = ray.find<Absorbed>()) passed_ = absorbed->passed;
        if (const auto* hit = ray.find<BoundaryChosen>()) object_ = hit->object;
    }

    void operator()(const Missed& e) { add(LightKind::background, e.background); }
    void operator()(const AmbientLit& e) { add(LightKind::ambient, e.scene * e.material); }
    void operator()(const LightLit& e) {
        add(LightKind::diffuse, e.diffuse);
        add(LightKind::specular, e.specular);
    }
    void operator()(const NotSpawned& e) {
        if (!(e.weight > 0) || e.reason == Reason::total_internal_reflection) return;
        DroppedRays& dropped = ledger_.dropped[{e.kind, e.reason}];
        ++dropped.count;
        const Colour whole = start_.weight * passed_;
        dropped.weight +=
            whole * (e.weight / largest_component(whole)); // the event tells the largest component
    }
    void operator()(const auto& /*event*/) {}

    /// What would have come back without absorption on this ray's way.
    void absorb(const RayFinished& end) {
        for (int i = 0; i < 3; ++i)
            if (passed_[i] > 0 && passed_[i] < 1)
                ledger_.absorbed[i] += start_.weight[i] * end.colour[i] * (1 / passed_[i] - 1);
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
    Colour passed_{1};
    Id object_ = none;
};

} // namespace

Ledger ledger_of(const std::vector<TracedRay>& rays) {
    Ledger ledger;
    for (const TracedRay& ray : rays) {
        if (ray.start().kind == RayKind::shadow) continue;
        Entry entry(ledger, ray);
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

} // namespace rayscope
