#pragma once
// How far numbers that a person or a program wrote as rounded decimals may be from what they mean. Readers of files
// judge by these; what is computed has error bounds instead.

namespace rayscope::decimals {

/// Of 1: radii that differ by less are a cylinder's.
inline constexpr double same_radius = 1e-12;

/// Distance from its plane of a polygon's vertex, in the polygon's size: for a file that can be edited.
inline constexpr double flatness = 1e-6;
/// The same for files with few digits that nobody edits.
inline constexpr double few_digits_flatness = 1e-3;

/// Area of a polygon in squares of its size: below, its vertices lie on one line.
inline constexpr double least_area = 1e-12;

/// Sine of the angle between a camera's view and its up: below, the image's horizontal would be made of rounding.
inline constexpr double least_sine = 1e-9;

} // namespace rayscope::decimals
