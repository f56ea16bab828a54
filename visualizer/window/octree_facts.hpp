#pragma once
// What one ray did in the octree, counted by levels.

#include "core/rayscope.hpp"

namespace rayscope::window {

/// What became of a cell.
enum class CellFate : std::uint8_t {
    divided, ///< the ray went on into parts of it
    tested,  ///< objects in it were tested
    spared,  ///< all its objects were tested before, or not needed any more
    empty,   ///< a part of a divided cell that holds nothing: it is not stored, and no ray comes to it
};
inline constexpr std::array<const char*, 4> fate_names{"divided", "tested", "spared", "empty"};

struct SeenCell {
    CellFate fate = CellFate::divided;
    int level = 0;  ///< below the root
    int held = 0;   ///< objects; of a divided cell the parts that are not empty
    int tested = 0; ///< objects, for the first time
    double t_in = 0, t_out = 0;
};

struct OctreeFacts {
    std::vector<SeenCell> cells; ///< that the ray came to, in its order
    int objects = 0;             ///< in the world
    int tested = 0, saved = 0;   ///< of them, in cells or not
    int deepest = 0;             ///< level
    double end = 0;              ///< t beyond which nothing was looked for

    /// How many of a fate on a level.
    [[nodiscard]] int count(CellFate fate, int level) const;
    /// The same on all levels down to `level`.
    [[nodiscard]] int count_to(CellFate fate, int level) const;
    /// Undivided cells that hold so many objects, on levels down to `level`.
    [[nodiscard]] std::vector<std::pair<int, int>> held_counts(int level) const;
};

/// @param trace found by an octree; nothing if the ray looked for nothing
[[nodiscard]] std::optional<OctreeFacts> octree_facts(const Trace& trace, int ray);

} // namespace rayscope::window
