#include "core/scene/toml_sections.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope {
namespace {

constexpr std::size_t most_named = 8;

struct Step {
    std::size_t compound = 0;
    std::size_t next_node = 0;
};

// a → b → a, the middle of a long circle left out.
std::string circle(const Scene& scene, const std::vector<Step>& path, std::size_t closing) {
    const auto start =
        std::find_if(path.begin(), path.end(), [&](const Step& s) { return s.compound == closing; });
    const auto length = std::size_t(path.end() - start);
    std::string names;
    for (std::size_t i = 0; i < std::min(length, most_named); ++i)
        names += scene.compounds[(start + std::ptrdiff_t(i))->compound].name + " → ";
    if (length > most_named) names += "… → ";
    return names + scene.compounds[closing].name;
}

} // namespace

// Depth first, with a stack of its own: a chain of compounds may be longer than the call stack.
void reject_cycles(const SourceText& source, const Scene& scene) {
    enum class State : unsigned char { untouched, open, done };
    std::vector<State> states(scene.compounds.size(), State::untouched);
    std::vector<Step> path;
    for (std::size_t root = 0; root < scene.compounds.size(); ++root) {
        if (states[root] == State::untouched) path.push_back({root, 0});
        while (!path.empty()) {
            const std::size_t current = path.back().compound;
            states[current] = State::open;
            const auto& nodes = scene.compounds[current].nodes;
            std::size_t& i = path.back().next_node;
            while (i < nodes.size() && !(nodes[i].is_compound && states[nodes[i].operand] != State::done))
                ++i;
            if (i == nodes.size()) {
                states[current] = State::done;
                path.pop_back();
                continue;
            }
            const SceneNode& leaf = nodes[i];
            if (states[leaf.operand] == State::open)
                source.fail(leaf.place, fmt::format("a compound can't contain itself: {}",
                                                    circle(scene, path, leaf.operand)));
            path.push_back({leaf.operand, 0});
        }
    }
}

} // namespace rayscope
