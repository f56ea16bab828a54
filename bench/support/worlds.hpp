#pragma once
// Scenes that a stage may like or not: beside clouds, a flake of balls, grids of compounds, gears.

#include "bench/support/clouds.hpp"

namespace rayscope::bench {

/// Camera, light, materials and a floor as in the measured peers' scenes; `size` is the width of what stands on it.
[[nodiscard]] Scene stand(double size);

/// A ball with nine half as large around it, and so on: 820 balls at level 3, 7381 at 4.
[[nodiscard]] Scene flake(int level);
/// n × n bowls: (A − B) − C of two spheres and a cone.
[[nodiscard]] Scene bowls(int n);
/// n × n cylinders with three holes each: ((D − A) − B) − C.
[[nodiscard]] Scene pierced_cylinders(int n);
/// n × n gears: a disc with a ring of teeth, and a hole for the axle.
[[nodiscard]] Scene gears(int n);

} // namespace rayscope::bench
