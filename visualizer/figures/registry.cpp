#include "visualizer/figures/figures.hpp"

#include <algorithm>
#include <utility>

namespace rayscope::figures {

Draw drawer_of(const std::string& name) {
    static constexpr std::pair<const char*, Draw> drawers[] = {
        {"inverse_ray", inverse_ray},
        {"normals_inverse_transpose", normals_inverse_transpose},
        {"two_spheres_hits", two_spheres_hits},
        {"hit_lists", hit_lists},
        {"expression_tree", expression_tree},
        {"bowl_cut", bowl_cut},
        {"cylinder_with_holes", cylinder_with_holes},
        {"cylinder_generics", cylinder_generics},
        {"sixteen_functions", sixteen_functions},
        {"mirrored_direction", mirrored_direction},
        {"recursion_level_3", recursion_level_3},
        {"two_media", two_media},
        {"critical_angle", critical_angle},
        {"prism_path", prism_path},
        {"projective_rectangles", projective_rectangles},
        {"coincident_faces", coincident_faces},
        {"light_components", light_components},
        {"depth_and_weight", depth_and_weight},
        {"nested_media", nested_media},
        {"dispersion_path", dispersion_path},
        {"textbook_and_stable", textbook_and_stable},
        {"energy_ledger", energy_ledger},
        {"edge_samples", edge_samples},
        {"soft_shadow", soft_shadow},
        {"cancellation", cancellation},
        {"error_against_time", error_against_time},
        {"near_plane_trap", near_plane_trap},
        {"light_cells", light_cells},
        {"octree_walk", octree_walk},
        {"time_against_n", time_against_n},
    };
    const auto* found = std::find_if(std::begin(drawers), std::end(drawers),
                                     [&](const auto& drawer) { return name == drawer.first; });
    return found == std::end(drawers) ? nullptr : found->second;
}

} // namespace rayscope::figures
