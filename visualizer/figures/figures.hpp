#pragma once
// All figures of the lessons. Each function draws one from a scene: what it shows comes from the core's inside lists,
// traces and images.

#include "visualizer/figures/svg.hpp"

#include <filesystem>

namespace rayscope::figures {

struct Subject {
    Workbench bench;                ///< of the scene that the figure names
    std::filesystem::path chapters; ///< the folder of all chapters: measurements are read from it
};

using Draw = Svg (*)(const Subject&);

/// Null if there is no such figure.
[[nodiscard]] Draw drawer_of(const std::string& name);

Svg inverse_ray(const Subject& subject);
Svg normals_inverse_transpose(const Subject& subject);
Svg two_spheres_hits(const Subject& subject);
Svg hit_lists(const Subject& subject);
Svg expression_tree(const Subject& subject);
Svg bowl_cut(const Subject& subject);
Svg cylinder_with_holes(const Subject& subject);
Svg cylinder_generics(const Subject& subject);
Svg sixteen_functions(const Subject& subject);
Svg mirrored_direction(const Subject& subject);
Svg recursion_level_3(const Subject& subject);
Svg two_media(const Subject& subject);
Svg critical_angle(const Subject& subject);
Svg prism_path(const Subject& subject);
Svg projective_rectangles(const Subject& subject);
Svg coincident_faces(const Subject& subject);
Svg light_components(const Subject& subject);
Svg depth_and_weight(const Subject& subject);
Svg nested_media(const Subject& subject);
Svg dispersion_path(const Subject& subject);
Svg textbook_and_stable(const Subject& subject);
Svg energy_ledger(const Subject& subject);
Svg edge_samples(const Subject& subject);
Svg soft_shadow(const Subject& subject);
Svg cancellation(const Subject& subject);
Svg error_against_time(const Subject& subject);
Svg near_plane_trap(const Subject& subject);
Svg light_cells(const Subject& subject);
Svg octree_walk(const Subject& subject);
Svg time_against_n(const Subject& subject);

} // namespace rayscope::figures
