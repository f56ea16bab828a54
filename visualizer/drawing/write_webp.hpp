#pragma once
// Rasters as an animated WebP, by libwebp.

#include "visualizer/drawing/picture.hpp"

#include <memory>
#include <string>

struct WebPAnimEncoder;

namespace rayscope::drawing {

class AnimatedWebp {
public:
    /// It runs in an endless loop.
    AnimatedWebp(int width, int height);

    /// @param frame of the animation's size; shown for so long
    void add(const Raster& frame, int milliseconds);
    /// The file. Nothing can be added afterwards.
    [[nodiscard]] std::string bytes();

private:
    struct Delete {
        void operator()(WebPAnimEncoder* encoder) const;
    };
    std::unique_ptr<WebPAnimEncoder, Delete> encoder_;
    int end_ = 0; // of what was added, in milliseconds
};

} // namespace rayscope::drawing
