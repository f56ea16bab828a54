#pragma once
// How wide a text is, shorter versions of it, and numbers for people.

#include "visualizer/drawing/canvas.hpp"

#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>

namespace rayscope::drawing {

/// DejaVu by file, so that every machine draws the same letters. Throws std::runtime_error if it is not installed.
[[nodiscard]] vtkSmartPointer<vtkTextProperty> text_property(Font font, double size, Rgb colour);

/// Width in pixels.
[[nodiscard]] double text_width(const std::string& text, Font font, double size);

/// The rectangle that a text covers.
[[nodiscard]] Area text_area(const Text& text);

/// At most `width` pixels wide: the middle is replaced by "…". Control characters become blanks.
[[nodiscard]] std::string elided(const std::string& text, Font font, double size, double width);

/// About `digits` significant digits, no trailing zeros: "0.85", "1.2e+06", "∞", "undefined" for NaN.
[[nodiscard]] std::string number(double value, int digits = 4);

/// Radians as degrees: "48.75°".
[[nodiscard]] std::string degrees(double radians);

} // namespace rayscope::drawing
