#pragma once
// A scene as a file for POV-Ray 3.7, which renders the same image (https://www.povray.org).

#include "core/scene/scene.hpp"
#include "core/world/world.hpp"

#include <string>
#include <vector>

namespace rayscope {

struct PovrayFile {
    std::string text;
    std::vector<std::string> differences; ///< what POV-Ray does in another way; the text's head says it, too
};

/// @param world built from the scene, in any numbers
[[nodiscard]] PovrayFile to_povray(const Scene& scene, const WorldBase& world);

} // namespace rayscope
