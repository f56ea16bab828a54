#include "core/image/image.hpp"

#include "core/files/atomic_file.hpp"
#include "core/image/encoders.hpp"
#include "core/math/hash.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <exception>
#include <stdexcept>
#include <string>

namespace rayscope {
namespace {

struct Format {
    const char* extension;
    void (*encode)(const Image&, const std::filesystem::path&);
};

constexpr std::array<Format, 3> formats{{{".png", encode_png}, {".pfm", encode_pfm}, {".exr", encode_exr}}};

const Format* format_of(const std::filesystem::path& path) {
    const std::string extension = path.extension().string();
    const auto* const found = std::find_if(
        formats.begin(), formats.end(), [&](const Format& format) { return extension == format.extension; });
    return found == formats.end() ? nullptr : found;
}

} // namespace

bool is_image_path(const std::filesystem::path& path) { return format_of(path) != nullptr; }

void write_image(const Image& image, const std::filesystem::path& path) {
    const Format* format = format_of(path);
    if (format == nullptr)
        throw std::runtime_error("can't write " + path.string() + ": expected .png, .pfm or .exr");
    AtomicFile file(path);
    try {
        format->encode(image, file.temporary());
    } catch (const std::exception& error) { // libraries name the temporary file, or none
        throw std::runtime_error("can't write " + path.string() + ": " + error.what());
    }
    file.commit();
}

std::uint64_t hash(const Image& image) {
    const std::array<std::uint32_t, 2> size{std::uint32_t(image.width), std::uint32_t(image.height)};
    return Fnv1a()
        .add(size.data(), sizeof size)
        .add(image.rgb.data(), image.rgb.size() * sizeof(float))
        .value();
}

} // namespace rayscope
