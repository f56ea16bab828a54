#include "core/image/image.hpp"
#include "core/image/srgb.hpp"
#include "tests/support/temporary_folder.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <gmock/gmock.h>
#include <png.h>

#include <cmath>
#include <cstring>

namespace rayscope::test {
namespace {

/// 3 × 2, every component different, with values outside [0, 1].
Image small_image() {
    Image image(3, 2);
    for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = float(i) * 0.125F - 0.25F;
    return image;
}

double srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

TEST(Srgb, bytes_are_the_standard_curve_rounded) {
    for (int i = -200; i <= 1200; ++i) {
        const float linear = float(i) / 1000;
        const double exact = 255 * srgb(std::clamp(double(linear), 0.0, 1.0));
        EXPECT_NEAR(srgb_byte(linear), exact, 0.5001) << linear;
    }
    EXPECT_EQ(srgb_byte(NAN), 0);
    EXPECT_EQ(srgb_byte(-INFINITY), 0);
    EXPECT_EQ(srgb_byte(INFINITY), 255);
    EXPECT_EQ(srgb_byte(1), 255);
    EXPECT_EQ(srgb_byte(0.5F), 188);
}

TEST(WriteImage, png_holds_srgb_bytes_from_the_top) {
    const TemporaryFolder folder;
    const std::string path = folder.path() / "a.png";
    const Image image = small_image();
    write_image(image, path);
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_file(&header, path.c_str()), 0) << header.message;
    header.format = PNG_FORMAT_RGB;
    EXPECT_EQ(header.width, 3U);
    EXPECT_EQ(header.height, 2U);
    std::vector<png_byte> bytes(18);
    ASSERT_NE(png_image_finish_read(&header, nullptr, bytes.data(), 0, nullptr), 0) << header.message;
    for (std::size_t i = 0; i < bytes.size(); ++i) EXPECT_EQ(bytes[i], srgb_byte(image.rgb[i])) << i;
}

TEST(WriteImage, pfm_holds_little_endian_floats_from_the_bottom) {
    const TemporaryFolder folder;
    const Image image = small_image();
    write_image(image, folder.path() / "a.pfm");
    const std::string content = content_of(folder.path() / "a.pfm");
    const std::string header = "PF\n3 2\n-1.0\n";
    ASSERT_EQ(content.substr(0, header.size()), header);
    ASSERT_EQ(content.size(), header.size() + 18 * 4);
    std::vector<float> floats(18);
    std::memcpy(floats.data(), content.data() + header.size(), 18 * 4);
    for (std::size_t i = 0; i < 9; ++i) {
        EXPECT_EQ(floats[i], image.rgb[9 + i]);
        EXPECT_EQ(floats[9 + i], image.rgb[i]);
    }
}

TEST(WriteImage, exr_holds_the_same_floats) {
    const TemporaryFolder folder;
    const std::string path = folder.path() / "a.exr";
    const Image image = small_image();
    write_image(image, path);
    Imf::InputFile file(path.c_str());
    EXPECT_EQ(file.header().dataWindow().max.x, 2);
    EXPECT_EQ(file.header().dataWindow().max.y, 1);
    std::vector<float> floats(18);
    Imf::FrameBuffer frame;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string channel(1, "RGB"[i]);
        ASSERT_EQ(file.header().channels()[channel.c_str()].type, Imf::FLOAT);
        frame.insert(channel.c_str(), Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(&floats[i]),
                                                 3 * sizeof(float), 9 * sizeof(float)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_EQ(floats, image.rgb);
}

TEST(WriteImage, a_failure_names_the_file_and_leaves_nothing) {
    const TemporaryFolder folder;
    EXPECT_THROW(write_image(small_image(), folder.path() / "a.gif"), std::runtime_error);
    // No format can hold an image without pixels: each encoder fails in its own way, or not at all.
    EXPECT_THROW(write_image(Image{}, folder.path() / "a.png"), std::runtime_error);
    for (const char* name : {"no/a.png", "no/a.pfm", "no/a.exr"}) {
        try {
            write_image(small_image(), folder.path() / name);
            ADD_FAILURE() << name;
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), testing::HasSubstr(name));
        }
    }
    EXPECT_THAT(folder.names(), testing::IsEmpty());
}

TEST(WriteImage, extensions_are_known) {
    EXPECT_TRUE(is_image_path("a/b.png") && is_image_path("b.pfm") && is_image_path("b.exr"));
    EXPECT_FALSE(is_image_path("png") || is_image_path("b.jpg") || is_image_path("") ||
                 is_image_path("b.png.gz"));
}

TEST(ImageHash, tells_size_order_and_every_bit) {
    const Image image = small_image();
    EXPECT_EQ(hash(image), hash(small_image()));
    EXPECT_NE(hash(Image(2, 3)), hash(Image(3, 2)));
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
        Image other = image;
        other.rgb[i] = std::nextafter(other.rgb[i], 9.0F);
        EXPECT_NE(hash(other), hash(image)) << i;
    }
}

} // namespace
} // namespace rayscope::test
