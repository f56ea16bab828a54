#include "core/image/encoders.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>

namespace rayscope {

void encode_exr(const Image& image, const std::filesystem::path& path) {
    constexpr std::size_t pixel = 3 * sizeof(float);
    Imf::Header header(image.width, image.height);
    Imf::FrameBuffer frame;
    // OpenEXR takes a non-const pointer for reading and writing alike; writing a file only reads.
    char* base = reinterpret_cast<char*>(const_cast<float*>(image.rgb.data()));
    for (const char* channel : {"R", "G", "B"}) {
        header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
        frame.insert(channel, Imf::Slice(Imf::FLOAT, base, pixel, pixel * std::size_t(image.width)));
        base += sizeof(float);
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(image.height);
}

} // namespace rayscope
