#include "core/accuracy/reference.hpp"

#include "core/accuracy/light_bound.hpp"
#include "core/accuracy/reference_cache.hpp"
#include "core/scene/build.hpp"

#include <chrono>
#include <cmath>

namespace rayscope {
namespace {

constexpr int band = 4; // rows that are computed at once
constexpr std::chrono::seconds between_savings{10};

bool same(const ReferenceSample& a, const ReferenceSample& b) {
    return a.colour == b.colour && a.lost == b.lost && a.first.object == b.first.object &&
           a.first.t == b.first.t && a.first.t_rest == b.first.t_rest;
}

class Maker {
public:
    Maker(const Scene& scene, const ReferenceOptions& options)
        : options_(options),
          cache_(options),
          world_(build<Float128>(scene)),
          eye_rays_(scene.camera, options.width, options.height) {
        world_.max_depth = options.limits.max_depth;
        world_.min_weight = options.limits.min_weight;
        world_.max_rays = options.limits.max_rays;
    }

    [[nodiscard]] Reference make() {
        result_.width = options_.width;
        result_.height = options_.height;
        result_.limits = options_.limits;
        resume();
        compute();
        judge();
        return std::move(result_);
    }

private:
    [[nodiscard]] int rows() const { return int(result_.samples.size() / std::size_t(options_.width)); }

    [[nodiscard]] std::vector<ReferenceSample> samples(int top, int bottom) const {
        RenderOptions options;
        options.threads = options_.threads;
        options.stop = options_.stop;
        return reference_samples(world_, eye_rays_, options_.width, top, bottom, options);
    }

    // What another version of the program left may hold other bits: one row tells.
    void resume() {
        result_.samples = cache_.load();
        if (result_.samples.empty()) return;
        const int row = rows() / 2;
        const auto again = samples(row, row + 1);
        const auto kept = result_.samples.begin() + std::ptrdiff_t(row) * options_.width;
        if (stopped() || std::equal(again.begin(), again.end(), kept, same)) return;
        result_.note = "the reference on disk is another version's; it is made anew";
        result_.samples.clear();
    }

    void compute() {
        auto saved = std::chrono::steady_clock::now();
        const int before = rows();
        for (int top = before; top < options_.height && !stopped(); top = rows()) {
            const auto next = samples(top, std::min(top + band, options_.height));
            if (stopped()) break; // the band may have holes
            result_.samples.insert(result_.samples.end(), next.begin(), next.end());
            if (options_.progress) options_.progress(double(rows()) / options_.height);
            if (std::chrono::steady_clock::now() - saved < between_savings) continue;
            save();
            saved = std::chrono::steady_clock::now();
        }
        if (rows() > before) save();
    }

    void save() {
        try {
            cache_.save(result_.samples);
        } catch (const std::exception& error) {
            result_.note = std::string("the reference is not kept: ") + error.what();
        }
    }

    void judge() {
        const Colour light = light_bound(world_, options_.limits.max_depth);
        double squares = 0, errors = 0;
        for (const ReferenceSample& sample : result_.samples) {
            const Colour missing = sample.lost * light;
            result_.uncertainty.push_back(largest_component(missing));
            result_.uncertainty_max = maximum(result_.uncertainty_max, result_.uncertainty.back());
            result_.uncertainty_mean += result_.uncertainty.back() / double(result_.samples.size());
            squares += dot(sample.colour, sample.colour);
            errors += dot(missing, missing);
        }
        // An image's pixels are floats: half a unit in the last place.
        const double rounding = double(epsilon<float>) / 2;
        result_.relative_rmse_floor =
            squares > 0 ? std::sqrt(errors / squares + rounding * rounding) : rounding;
    }

    [[nodiscard]] bool stopped() const { return options_.stop != nullptr && *options_.stop; }

    const ReferenceOptions& options_;
    ReferenceCache cache_;
    World<Float128> world_;
    EyeRays eye_rays_;
    Reference result_;
};

} // namespace

Reference make_reference(const Scene& scene, const ReferenceOptions& options) {
    return Maker(scene, options).make();
}

} // namespace rayscope
