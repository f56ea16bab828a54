// The figures that are kept with the lessons are the ones that the program draws.

#include "core/image/ssim.hpp"
#include "tests/support/temporary_folder.hpp"
#include "visualizer/figures/catalogue.hpp"

#include <gtest/gtest.h>

#include <png.h>
#include <vtkBase64Utilities.h>

namespace rayscope::figures {
namespace {

namespace fs = std::filesystem;

const fs::path chapters = fs::path(RAYSCOPE_SOURCE_DIR) / "chapters";

constexpr std::string_view data_begin = "base64,";
constexpr double alike = 0.99; // what one graphics library draws otherwise than another is far less

std::vector<std::uint8_t> decoded(const std::string& base64) {
    std::vector<std::uint8_t> bytes(base64.size());
    bytes.resize(vtkBase64Utilities::DecodeSafely(reinterpret_cast<const unsigned char*>(base64.data()),
                                                  base64.size(), bytes.data(), bytes.size()));
    return bytes;
}

Luma picture_of(const std::vector<std::uint8_t>& png) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&header, png.data(), png.size()) == 0)
        throw std::runtime_error(header.message);
    header.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> rgb(PNG_IMAGE_SIZE(header));
    const png_color white{255, 255, 255};
    if (png_image_finish_read(&header, &white, rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(header.message);
    return luma(rgb, int(header.width), int(header.height));
}

/// A figure without the pictures in it, whose last bits are the graphics library's, and those pictures.
struct Parts {
    std::string vectors;
    std::vector<Luma> pictures;
};
Parts parts_of(std::string svg) {
    Parts parts;
    for (auto at = svg.find(data_begin); at != std::string::npos;
         at = svg.find(data_begin, at + data_begin.size())) {
        const std::size_t from = at + data_begin.size(), length = svg.find('"', at) - from;
        parts.pictures.push_back(picture_of(decoded(svg.substr(from, length))));
        svg.erase(from, length);
    }
    parts.vectors = std::move(svg);
    return parts;
}

bool has_picture(const std::string& svg) { return svg.find(data_begin) != std::string::npos; }

void compare(bool with_picture) {
    for (const Entry& entry : read_catalogue()) {
        const std::string kept = test::content_of(chapters / entry.file());
        if (has_picture(kept) != with_picture) continue;
        SCOPED_TRACE(entry.name + ": ./rayscope figures --only " + entry.name + " draws it anew");
        const Parts now = parts_of(drawn(entry, chapters)), before = parts_of(kept);
        EXPECT_EQ(now.vectors, before.vectors);
        ASSERT_EQ(now.pictures.size(), before.pictures.size());
        for (std::size_t i = 0; i < now.pictures.size(); ++i) {
            ASSERT_EQ(now.pictures[i].width, before.pictures[i].width);
            ASSERT_EQ(now.pictures[i].height, before.pictures[i].height);
            EXPECT_GE(ssim(now.pictures[i], before.pictures[i]), alike) << "picture " << i;
        }
    }
}

TEST(Committed, FiguresOfLinesAreDrawnAgainAlike) { compare(false); }
TEST(CommittedFull, FiguresWithPicturesAreDrawnAgainAlike) { compare(true); }

TEST(Committed, AreSmallAndSayWhatTheyShow) {
    for (const Entry& entry : read_catalogue()) {
        const std::string kept = test::content_of(chapters / entry.file());
        EXPECT_GT(kept.size(), 500U) << entry.name;
        EXPECT_LE(kept.size(), 250'000U) << entry.name;
        EXPECT_NE(kept.find("<title>"), std::string::npos) << entry.name;
        EXPECT_NE(kept.find("<desc>"), std::string::npos) << entry.name;
    }
}

TEST(Committed, LessonsShowFiguresWithTheirWords) {
    for (const Entry& entry : read_catalogue()) {
        const std::string lesson = test::content_of(chapters / entry.chapter / "README.md");
        EXPECT_NE(lesson.find("![" + entry.alt + "](figures/" + entry.name + ".svg)"), std::string::npos)
            << entry.name;
    }
}

} // namespace
} // namespace rayscope::figures
