#include "core/tracer/antialiasing.hpp"

#include "core/image/srgb.hpp"

#include <cmath>

namespace rayscope {
namespace {

// Of the surface's directions: beyond about 18 degrees an edge is seen.
constexpr double least_cosine = 0.95;
// Of colours, in steps of an image file: two neighbours this far apart make a visible step.
constexpr int largest_step = 3;

} // namespace

bool differ(const Colour& a, const Colour& b) {
    const auto one = srgb_bytes(a), other = srgb_bytes(b);
    for (std::size_t i = 0; i < one.size(); ++i)
        if (std::abs(int(one[i]) - int(other[i])) > largest_step) return true;
    return false;
}

std::vector<bool> uneven_pixels(const Image& image, const std::vector<FirstSeen>& seen) {
    std::vector<bool> uneven(seen.size());
    const auto index = [&](int x, int y) {
        return std::size_t(y) * std::size_t(image.width) + std::size_t(x);
    };
    const auto compare = [&](int x, int y, int other_x, int other_y) {
        if (other_x < 0 || other_x >= image.width || other_y >= image.height) return;
        const std::size_t a = index(x, y), b = index(other_x, other_y);
        const bool same = seen[a].object == seen[b].object &&
                          (seen[a].object == none || dot(seen[a].normal, seen[b].normal) > least_cosine) &&
                          !differ(image.at(x, y), image.at(other_x, other_y));
        if (!same) uneven[a] = uneven[b] = true;
    };
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            compare(x, y, x + 1, y);
            for (int aside = -1; aside <= 1; ++aside) compare(x, y, x + aside, y + 1);
        }
    }
    return uneven;
}

} // namespace rayscope
