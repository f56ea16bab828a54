#pragma once
// A recorded ray as it stands in a page: its inside intervals drawn, its rays as a table.

#include <filesystem>
#include <string>

namespace rayscope::exercises {

/// HTML of the ray ("ox,oy,oz,dx,dy,dz") through the scene, without anything from outside. Throws InputError.
[[nodiscard]] std::string drawn_ray(const std::filesystem::path& scene, const std::string& ray);

} // namespace rayscope::exercises
