#pragma once
// How far numbers that a person or a program wrote as rounded decimals may be from what they mean. Readers of files
// judge by these; what is computed has error bounds instead.

namespace rayscope::decimals {

/// Of 1: radii that differ by less are a cylinder's.
inline constexpr double same_radius = 1e-12;

/// Distance from its plane of a polygon's vertex, in the polygon's size: for a file that can be edited.
inline constexpr double flatness = 1e-6;
/// For files that programs write with six digits: how far they may move a coordinate, as a share of the largest one.
inline constexpr double six_digits = 1e-5;
/// At most so much of the polygon's size, however far away it lies.
inline constexpr double largest_flatness = 1e-3;

/// Area of a polygon in squares of its size: below, its vertices lie on one line.
inline constexpr double least_area = 1e-12;

/// Sine of the angle between a camera's view and its up: below, the image's horizontal would be made of rounding.
inline constexpr double least_sine = 1e-9;

} // namespace rayscope::decimals
