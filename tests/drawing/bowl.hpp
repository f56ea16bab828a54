#pragma once
// The scene of most tests here: the glass bowl that ships.

#include "core/rayscope.hpp"

namespace rayscope::test {

inline const Workbench& bowl() {
    static const Workbench bench =
        open(std::filesystem::path(RAYSCOPE_SOURCE_DIR) / "chapters/02_csg/glass_bowl.toml");
    return bench;
}

inline Trace bowl_trace() {
    const auto [x, y] = bowl().scene.step_pixel.value();
    return trace_pixel(bowl(), x, y);
}

} // namespace rayscope::test
