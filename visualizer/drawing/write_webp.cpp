#include "visualizer/drawing/write_webp.hpp"

#include <stdexcept>

#include <webp/encode.h>
#include <webp/mux.h>

namespace rayscope::drawing {
namespace {

constexpr int effort = 3; // of 0 … 9: more takes seconds a frame, and saves a tenth

void check(int good, WebPAnimEncoder* encoder) {
    if (good == 0)
        throw std::runtime_error(std::string("can't make the animation: ") +
                                 WebPAnimEncoderGetError(encoder));
}

/// libwebp's own copy of a raster.
class Frame {
public:
    explicit Frame(const Raster& raster) {
        WebPPictureInit(&picture);
        picture.use_argb = 1;
        picture.width = raster.width;
        picture.height = raster.height;
        if (WebPPictureImportRGB(&picture, raster.bytes.data(), 3 * raster.width) == 0)
            throw std::runtime_error("can't make the animation: out of memory");
    }
    ~Frame() { WebPPictureFree(&picture); }
    Frame(const Frame&) = delete;
    Frame& operator=(const Frame&) = delete;

    WebPPicture picture;
};

} // namespace

void AnimatedWebp::Delete::operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }

AnimatedWebp::AnimatedWebp(int width, int height) {
    WebPAnimEncoderOptions options;
    WebPAnimEncoderOptionsInit(&options);
    options.kmax = 0; // each frame but the first holds what changes in it
    encoder_.reset(WebPAnimEncoderNew(width, height, &options));
    if (encoder_ == nullptr) throw std::runtime_error("can't make an animation of this size");
}

void AnimatedWebp::add(const Raster& frame, int milliseconds) {
    WebPConfig config;
    WebPConfigInit(&config);
    WebPConfigLosslessPreset(&config, effort); // text stays sharp
    Frame copy(frame);
    check(WebPAnimEncoderAdd(encoder_.get(), &copy.picture, end_, &config), encoder_.get());
    end_ += milliseconds;
}

std::string AnimatedWebp::bytes() {
    check(WebPAnimEncoderAdd(encoder_.get(), nullptr, end_, nullptr), encoder_.get());
    WebPData data;
    WebPDataInit(&data);
    check(WebPAnimEncoderAssemble(encoder_.get(), &data), encoder_.get());
    std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
    WebPDataClear(&data);
    return bytes;
}

} // namespace rayscope::drawing
