#pragma once
// A picture of a scene's surfaces, without any text, to lie under a figure's lines.

#include "visualizer/figures/sheet.hpp"

namespace rayscope::figures {

struct Stand {
    Vec3d back{0.35, 0.35, 1}; ///< from the things towards the camera
    Vec3d up{0, 1, 0};
    Vec3d centre{0};
    double radius = 1;  ///< of the ball that is shown
    double share = 0.9; ///< of the area that the ball fills
    bool opaque = false;
    double detail = 1;       ///< picture points for each unit of the page
    std::vector<Vec3d> seen; ///< what must be in the picture; empty: the box of the ball
};

/// Draws the surfaces in the area, and tells where points of the world land on the page.
class Solid {
public:
    Solid(Svg& svg, const drawing::Area& area, const Workbench& bench, const Stand& stand);
    [[nodiscard]] Pixel operator()(const Vec3d& world) const;
    [[nodiscard]] Pixel operator()(const Vec3d& world, double x, double y) const;

private:
    drawing::Region region_;
    drawing::View view_;
};

/// Bytes of a PNG file.
[[nodiscard]] std::vector<std::uint8_t> png_of(const Image& image);

} // namespace rayscope::figures
