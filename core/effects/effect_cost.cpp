#include "core/effects/effect_cost.hpp"

#include "core/accuracy/colour_difference.hpp"
#include "core/effects/change_effects.hpp"
#include "core/image/ssim.hpp"
#include "core/scene/build.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr int smallest_side = 11; // of a window of the SSIM

/// A scene, and its renders so far.
struct Variant {
    Effect effect;
    bool taken_away;
    World<double> world;
    Camera camera;
    RenderResult last;
    std::vector<double> seconds;
};

double median(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

Colour mean_light(const Image& image) {
    Colour sum{0};
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) sum += image.at(x, y);
    return sum / (double(image.width) * image.height);
}

double mean_difference(const Image& a, const Image& b) {
    double sum = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x) sum += ciede2000(lab_of(a.at(x, y)), lab_of(b.at(x, y)));
    return sum / (double(a.width) * a.height);
}

EffectCost cost_of(const Variant& base, Variant& changed) {
    EffectCost cost;
    cost.effect = changed.effect;
    cost.taken_away = changed.taken_away;
    const Variant &with = changed.taken_away ? base : changed, &without = changed.taken_away ? changed : base;
    std::vector<double> ratios;
    for (std::size_t i = 0; i < base.seconds.size(); ++i)
        ratios.push_back(with.seconds[i] / without.seconds[i]);
    cost.time_ratio = median(ratios);
    const auto [least, greatest] = std::ranges::minmax_element(ratios);
    cost.least_ratio = *least;
    cost.greatest_ratio = *greatest;
    const Image &a = with.last.image, &b = without.last.image;
    cost.difference = mean_difference(a, b);
    cost.similarity = std::min(a.width, a.height) < smallest_side ? not_a_number : ssim(luma(a), luma(b));
    cost.light = mean_light(a) - mean_light(b);
    for (std::size_t kind = 0; kind < cost.rays.size(); ++kind)
        cost.rays[kind] = std::int64_t(with.last.statistics.counters.rays[kind]) -
                          std::int64_t(without.last.statistics.counters.rays[kind]);
    cost.image = std::move(changed.last.image);
    return cost;
}

} // namespace

EffectCosts effect_costs(const Scene& scene, const EffectSet& needed, const EffectCostOptions& options) {
    EffectCosts costs;
    std::vector<Variant> variants;
    variants.push_back({Effect::ambient, false, build(scene), scene.camera, {}, {}});
    for (std::size_t i = 0; i < effect_names.size(); ++i) {
        const auto effect = Effect(i);
        Scene changed = scene;
        if (needed.has(effect)) {
            take_away(effect, changed);
        } else if (!add_effect(effect, changed)) {
            costs.nowhere.push_back(effect);
            continue;
        }
        variants.push_back({effect, needed.has(effect), build(changed), changed.camera, {}, {}});
    }
    const double steps = double(options.rounds) * double(variants.size());
    double done = 0;
    for (int round = 0; round < options.rounds; ++round) {
        for (Variant& variant : variants) {
            RenderOptions one = options.render;
            if (options.render.progress)
                one.progress = [&](double share) { options.render.progress((done + share) / steps); };
            variant.last = render(variant.world, variant.camera, one);
            if (!variant.last.complete) {
                costs.complete = false;
                return costs;
            }
            variant.seconds.push_back(variant.last.statistics.cpu_seconds);
            ++done;
        }
    }
    for (std::size_t i = 1; i < variants.size(); ++i)
        costs.effects.push_back(cost_of(variants.front(), variants[i]));
    costs.scene = std::move(variants.front().last.image);
    return costs;
}

Image strip(const EffectCosts& costs, const EffectCost& cost) {
    constexpr double magnified = 8, grey = 0.5;
    const Image &with = cost.taken_away ? costs.scene : cost.image,
                &without = cost.taken_away ? cost.image : costs.scene;
    Image strip(3 * with.width, with.height);
    for (int y = 0; y < with.height; ++y) {
        for (int x = 0; x < with.width; ++x) {
            const Colour a = with.at(x, y), b = without.at(x, y);
            strip.set(x, y, a);
            strip.set(with.width + x, y, b);
            strip.set(2 * with.width + x, y, Colour{grey} + magnified * (a - b));
        }
    }
    return strip;
}

} // namespace rayscope
