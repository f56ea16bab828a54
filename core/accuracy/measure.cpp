#include "core/accuracy/measure.hpp"

#include "core/scene/build.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rayscope {
namespace {

constexpr double least_time = 0.02; // seconds: what is shorter is rendered several times for one run
constexpr int most_repetitions = 20;

// About how long an image takes, in those of double: for the progress alone.
double expected_effort(const Configuration& configuration) {
    switch (configuration.numbers.scalar) {
    case ScalarType::float80: return 3;
    case ScalarType::float128: return 70;
    default: return 1;
    }
}

// One configuration, ready to be rendered again and again.
class Candidate {
public:
    Candidate(const Scene& scene, const Configuration& configuration, const Reference& reference,
              const MeasureOptions& options)
        : scene_(scene), configuration_(configuration), reference_(reference), options_(options) {
        rendering_.width = reference.width;
        rendering_.height = reference.height;
        rendering_.threads = options.threads;
        rendering_.stop = options.stop;
    }

    /// The first run also says how wrong the image is.
    void run() {
        with_numbers(configuration_.numbers, [&]<Numbers N>() {
            auto world = build<N>(scene_);
            world.max_depth = configuration_.max_depth;
            world.min_weight = configuration_.min_weight;
            if (seconds_.empty()) compare(world);
            double sum = 0;
            for (int i = 0; i < repetitions_ && !stopped(); ++i)
                sum += render(world, scene_.camera, rendering_).statistics.cpu_seconds;
            seconds_.push_back(sum / repetitions_);
        });
    }

    [[nodiscard]] Measured result() {
        std::sort(seconds_.begin(), seconds_.end());
        const std::size_t half = seconds_.size() / 2;
        const double median =
            seconds_.size() % 2 == 1 ? seconds_[half] : (seconds_[half - 1] + seconds_[half]) / 2;
        return {configuration_,
                {median, seconds_.front(), seconds_.back(), int(seconds_.size())},
                error_,
                false,
                map_};
    }

private:
    template <Numbers N> void compare(const World<N>& world) {
        const RenderResult result = render(world, scene_.camera, rendering_);
        const auto hits = first_hits(world, scene_.camera, rendering_);
        if (stopped()) return;
        Map map;
        error_ = image_error(result.image, hits, reference_, options_.on_map ? &map : nullptr);
        if (options_.on_map) map_ = options_.on_map(configuration_, map);
        const double time = result.statistics.cpu_seconds;
        repetitions_ =
            time > 0 ? std::clamp(int(std::ceil(least_time / time)), 1, most_repetitions) : most_repetitions;
    }
    [[nodiscard]] bool stopped() const { return options_.stop != nullptr && *options_.stop; }

    const Scene& scene_;
    Configuration configuration_;
    const Reference& reference_;
    const MeasureOptions& options_;
    RenderOptions rendering_;
    ImageError error_;
    std::string map_;
    int repetitions_ = 1;
    std::vector<double> seconds_;
};

void mark_front(std::vector<Measured>& list, const Reference& reference) {
    std::vector<std::size_t> order(list.size());
    std::iota(order.begin(), order.end(), 0);
    const auto key = [&](std::size_t i) {
        return std::pair(list[i].seconds.median, ranked_error(list[i], reference));
    };
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    double best = infinity<double>;
    for (const std::size_t i : order) {
        const double error = ranked_error(list[i], reference);
        // Less than the reference's own uncertainty is no gain.
        list[i].on_front = best == infinity<double> || error < best - reference.relative_rmse_floor;
        best = minimum(best, error);
    }
}

} // namespace

double ranked_error(const Measured& measured, const Reference& reference) {
    return maximum(measured.error.relative_rmse, reference.relative_rmse_floor);
}

std::vector<Measured> measure(const Scene& scene, const std::vector<Configuration>& configurations,
                              const Reference& reference, const MeasureOptions& options) {
    std::vector<Candidate> candidates;
    double total = 0, done = 0;
    for (const Configuration& configuration : configurations) {
        candidates.emplace_back(scene, configuration, reference, options);
        total += expected_effort(configuration) * (options.runs + 1); // and one for the error
    }
    for (int round = 0; round < options.runs; ++round) {
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            candidates[i].run();
            if (options.stop != nullptr && *options.stop) return {};
            done += expected_effort(configurations[i]) * (round == 0 ? 2 : 1);
            if (options.progress) options.progress(done / total);
        }
    }
    std::vector<Measured> result;
    for (Candidate& candidate : candidates) result.push_back(candidate.result());
    mark_front(result, reference);
    return result;
}

} // namespace rayscope
