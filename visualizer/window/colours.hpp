#pragma once
// The pictures' colours for Qt.

#include "visualizer/drawing/palette.hpp"

#include <QColor>

namespace rayscope::window {

[[nodiscard]] inline QColor qt_colour(drawing::Rgb c) { return {c.red, c.green, c.blue}; }

} // namespace rayscope::window
