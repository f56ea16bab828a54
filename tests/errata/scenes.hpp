#pragma once
// The chapters' scenes, which are the counter-examples that a reader may walk through.

#include "core/rayscope.hpp"

#include <string>

namespace rayscope::test {

/// @param path from chapters/: "03_reflection/mirror.toml"
[[nodiscard]] inline Workbench chapter_scene(const std::string& path) {
    return open(RAYSCOPE_SOURCE_DIR "/chapters/" + path);
}

} // namespace rayscope::test
