#include "core/scene/scene.hpp"

namespace rayscope {

bool SceneMaterial::transmits() const {
    if (mirror != Mirror::constant) return true;
    const auto& pattern = patterns.transmission;
    return largest_component(pattern ? maximum_of(pattern->even, pattern->odd) : transmission) > 0;
}

} // namespace rayscope
