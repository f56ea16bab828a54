#include "core/accuracy/verdict.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rayscope {
namespace {

const Measured* find(const std::vector<Measured>& list, const Configuration& configuration) {
    const auto found = std::find_if(list.begin(), list.end(),
                                    [&](const Measured& m) { return m.configuration == configuration; });
    return found == list.end() ? nullptr : &*found;
}

std::string short_name(const NumbersChoice& numbers) {
    return fmt::format("{} {}", scalar_name(numbers.scalar), method_name(numbers.method));
}

std::string pixels(std::size_t count) {
    return fmt::format("{} wrong pixel{}", count, count == 1 ? "" : "s");
}

std::string times(const Measured& dear, const Measured& cheap) {
    return fmt::format("{:.2f} times", dear.seconds.median / cheap.seconds.median);
}

// The stable formulas against the schoolbook's.
std::optional<std::string> on_method(const std::vector<Measured>& list, const Measured& base) {
    Configuration other = base.configuration;
    other.numbers = {ScalarType::float32, Method::textbook};
    const Measured* school = find(list, other);
    if (school == nullptr || school == &base) return std::nullopt;
    const std::size_t wrong = school->error.wrong_pixels, left = base.error.wrong_pixels;
    std::string gain;
    if (wrong == 0 && left == 0)
        gain = fmt::format("neither has a wrong pixel, the relative RMSE is {:.2g} instead of {:.2g}",
                           base.error.relative_rmse, school->error.relative_rmse);
    else if (left == 0)
        gain = wrong == 1 ? "removes its wrong pixel" : fmt::format("removes all its {}", pixels(wrong));
    else
        gain = fmt::format("has {} instead of {}", pixels(left), wrong);
    return fmt::format("{} costs {} what {} does{} {}.", short_name(base.configuration.numbers),
                       times(base, *school), short_name(other.numbers),
                       wrong == 0 && left == 0 ? ";" : " and", gain);
}

// The scene's depth against the deepest of the smaller ones.
std::optional<std::string> on_depth(const std::vector<Measured>& list, const Measured& base) {
    const Measured* shallow = nullptr;
    for (const Measured& m : list) {
        Configuration same = m.configuration;
        same.max_depth = base.configuration.max_depth;
        if (same == base.configuration && m.configuration.max_depth < base.configuration.max_depth &&
            (shallow == nullptr || m.configuration.max_depth > shallow->configuration.max_depth))
            shallow = &m;
    }
    if (shallow == nullptr) return std::nullopt;
    std::string gain = "changes nothing that a screen shows";
    if (base.error.psnr && shallow->error.psnr) {
        const double won = *base.error.psnr - *shallow->error.psnr;
        gain = fmt::format("{} {:.1f} dB", won < 0 ? "loses" : "wins", std::abs(won));
    } else if (shallow->error.psnr) {
        gain = "removes all that a screen shows of the error";
    }
    return fmt::format("Depth {} instead of {} costs {} as much and {}.", base.configuration.max_depth,
                       shallow->configuration.max_depth, times(base, *shallow), gain);
}

std::string on_best(const std::vector<Measured>& list, const Reference& reference) {
    const auto best = std::min_element(list.begin(), list.end(), [&](const Measured& a, const Measured& b) {
        return std::pair(ranked_error(a, reference), a.seconds.median) <
               std::pair(ranked_error(b, reference), b.seconds.median);
    });
    const double error = ranked_error(*best, reference);
    if (error <= reference.relative_rmse_floor)
        return fmt::format("{} is the cheapest that the reference can't tell from itself.",
                           name_of(best->configuration));
    return fmt::format("{} comes nearest to the reference: a relative RMSE of {:.2g}.",
                       name_of(best->configuration), error);
}

} // namespace

std::vector<std::string> verdict(const std::vector<Measured>& list, const Reference& reference) {
    std::vector<std::string> sentences;
    if (list.empty()) return sentences;
    if (auto sentence = on_method(list, list.front())) sentences.push_back(*std::move(sentence));
    if (auto sentence = on_depth(list, list.front())) sentences.push_back(*std::move(sentence));
    sentences.push_back(on_best(list, reference));
    return sentences;
}

const Measured* cheapest_within(const std::vector<Measured>& list, const Reference& reference,
                                double target) {
    const Measured* cheapest = nullptr;
    for (const Measured& m : list)
        if (ranked_error(m, reference) <= target &&
            (cheapest == nullptr || m.seconds.median < cheapest->seconds.median))
            cheapest = &m;
    return cheapest;
}

} // namespace rayscope
