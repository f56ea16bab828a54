#include "core/scene/wording.hpp"

#include "core/files/utf8.hpp"

#include <algorithm>

namespace rayscope {
namespace {

constexpr std::size_t longest_quote = 60;
constexpr std::size_t longest_name = 64; // keeps the quadratic comparison small
constexpr std::size_t most_candidates = 10000;

// Edit distance with swaps of neighbours (Damerau 1964, restricted form): three rows of its table.
std::size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, previous(b.size() + 1), current(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        current[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            current[j] = std::min({replaced, previous[j] + 1, current[j - 1] + 1});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) current[j] = std::min(current[j], before[j - 2] + 1);
        }
        before = previous;
        std::swap(previous, current);
    }
    return previous[b.size()];
}

} // namespace

std::string in_quotes(std::string_view text) {
    std::string shown = "'";
    std::size_t offset = 0, characters = 0;
    for (; offset < text.size() && characters < longest_quote; ++characters) {
        const std::size_t length = utf8_length(text.substr(offset));
        if (length == 0 || steers_terminal(utf8_code_point(text.substr(offset, length))))
            shown += '?';
        else
            shown += text.substr(offset, length);
        offset += std::max<std::size_t>(length, 1);
    }
    if (offset < text.size()) shown += "…";
    return shown + "'";
}

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
    if (name.empty() || name.size() > longest_name) return {};
    std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
    std::string_view nearest;
    for (std::size_t i = 0; i < std::min(candidates.size(), most_candidates); ++i) {
        const std::string_view candidate = candidates[i];
        const std::size_t longer = std::max(candidate.size(), name.size());
        const std::size_t shorter = std::min(candidate.size(), name.size());
        if (longer > longest_name || longer - shorter >= least) continue;
        const std::size_t distance = edit_distance(name, candidate);
        // A candidate that shares no letter is no hint.
        if (distance < least && distance < longer) {
            least = distance;
            nearest = candidate;
        }
    }
    return nearest.empty() ? std::string{} : "; did you mean '" + std::string(nearest) + "'?";
}

std::string one_of(const std::vector<std::string_view>& choices) {
    std::string text;
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (i > 0) text += i + 1 == choices.size() ? " or " : ", ";
        text += choices[i];
    }
    return text;
}

} // namespace rayscope
