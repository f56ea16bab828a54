#include "tests/povray/povray.hpp"

#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

namespace rayscope::test {
namespace {

/// A binary PPM of 8 bits, perhaps with comments.
Luma read_ppm(const std::filesystem::path& path) {
    std::istringstream in(content_of(path));
    std::string kind;
    in >> kind;
    const auto next = [&] {
        int number = 0;
        while ((in >> std::ws).peek() == '#') in.ignore(1000, '\n');
        in >> number;
        return number;
    };
    const int width = next(), height = next(), most = next();
    in.get();
    EXPECT_EQ(kind, "P6");
    EXPECT_EQ(most, 255);
    std::vector<std::uint8_t> rgb(std::istreambuf_iterator<char>(in), {});
    EXPECT_EQ(rgb.size(), 3 * std::size_t(width) * std::size_t(height));
    return luma(rgb, width, height);
}

} // namespace

bool povray_is_installed() { return std::system("povray --version >/dev/null 2>&1") == 0; }

Luma render_by_povray(const std::string& text, int width, int height) {
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "scene.pov") << text;
    std::ostringstream command;
    command << "cd '" << folder.path().string() << "' && povray +Iscene.pov +W" << width << " +H" << height
            << " -A -D +WT1 File_Gamma=sRGB +FP +Oimage.ppm >log 2>&1 </dev/null";
    EXPECT_EQ(std::system(command.str().c_str()), 0) << content_of(folder.path() / "log");
    return read_ppm(folder.path() / "image.ppm");
}

} // namespace rayscope::test
