// The five parts of the light that a point sends to the eye, each as an image of its own.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"
#include "visualizer/figures/solid.hpp"

#include <array>
#include <numeric>

namespace rayscope::figures {
namespace {

enum Part : std::uint8_t {
    ambient_part,
    diffuse_part,
    specular_part,
    reflected_part,
    transmitted_part,
    parts
};

/// What the first ray of a trace adds up, part by part. The background belongs to none of them.
std::array<Colour, parts> parts_of(const Trace& trace) {
    std::array<Colour, parts> light;
    light.fill(Colour{0});
    const TracedRay& first = trace.rays.front();
    for (const Event& event : first.events) {
        if (const auto* lit = std::get_if<AmbientLit>(&event))
            light[ambient_part] += lit->scene * lit->material;
        if (const auto* lit = std::get_if<LightLit>(&event)) {
            light[diffuse_part] += lit->diffuse;
            light[specular_part] += lit->specular;
        }
    }
    for (const int child : first.children) {
        const TracedRay& ray = trace.rays[std::size_t(child)];
        if (ray.start().kind == RayKind::shadow) continue;
        light[ray.start().kind == RayKind::reflected ? reflected_part : transmitted_part] +=
            ray.start().weight * ray.find<RayFinished>()->colour;
    }
    return light;
}

} // namespace

Svg light_components(const Subject& subject) {
    constexpr int width = 240, height = 180;
    Svg svg(1000, 580);
    std::array<Image, parts> images;
    images.fill(Image(width, height));
    Image sum(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Trace trace = trace_pixel(subject.bench, x, y, width, height);
            const auto light = parts_of(trace);
            for (std::size_t i = 0; i < parts; ++i) images[i].set(x, y, light[i]);
            const Colour all = std::accumulate(light.begin(), light.end(), Colour{0});
            if (largest_component(glm::abs(all - trace.colour)) > 1e-9)
                throw InputError(subject.bench.scene.file, {},
                                 "a pixel has light that is none of the five parts");
            sum.set(x, y, all);
        }
    struct Place {
        const Image& image;
        const char *name, *sign;
    };
    const Place places[] = {
        {images[ambient_part], "ambient", ""},          {images[diffuse_part], "diffuse", "+"},
        {images[specular_part], "specular", "+"},       {images[reflected_part], "reflected", "+"},
        {images[transmitted_part], "transmitted", "+"}, {sum, "the sum of all five", "="}};
    for (std::size_t i = 0; i < std::size(places); ++i) {
        const Place& place = places[i];
        const drawing::Area area{40 + 324 * double(i % 3), 12 + 300 * double(i / 3), 288, 216};
        svg.image(area, png_of(place.image));
        svg.frame(area, {place.sign[0] == '=' ? black : grey, place.sign[0] == '=' ? 4.0 : 1.5});
        svg.text({area.x - 19, area.y + 108}, place.sign, {30, black, true});
        svg.text({area.x + 144, area.y + 242}, place.name, {22, black, true});
    }
    return svg;
}

} // namespace rayscope::figures
