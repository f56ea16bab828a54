#pragma once
// The image of the scene, coarse first and then fine, made beside the window.

#include "core/rayscope.hpp"
#include "visualizer/window/worker.hpp"

#include <QImage>

#include <memory>

namespace rayscope::window {

struct MadeImage {
    QImage picture; ///< of any size: the scene's image has `width` × `height` pixels
    int width = 0, height = 0;
    bool fine = false;        ///< one of each pixel
    std::optional<Heat> heat; ///< it shows what pixels cost …
    double most = 0;          ///< … from 0 to this
    double seconds = 0;       ///< since it was asked for
};

class ImageMaker {
public:
    ImageMaker(QObject* home, std::function<void(const MadeImage&)> show)
        : show_(std::move(show)), worker_(home) {}

    void make(std::shared_ptr<const Workbench> bench, std::optional<Heat> heat);
    [[nodiscard]] bool busy() const { return worker_.busy(); }

private:
    std::function<void(const MadeImage&)> show_;
    Worker worker_; // last: it ends before what it calls goes
};

/// What a screen shows of it.
[[nodiscard]] QImage screen_image(const Image& image);

} // namespace rayscope::window
