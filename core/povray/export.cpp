#include "core/povray/export.hpp"

#include "core/povray/compounds.hpp"
#include "core/povray/differences.hpp"
#include "core/povray/frame.hpp"
#include "core/povray/shapes.hpp"
#include "core/povray/textures.hpp"
#include "core/povray/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numbers>

namespace rayscope {
namespace povray {
namespace {

class Exporter {
public:
    Exporter(const Scene& scene, const WorldBase& world)
        : scene_(scene), world_(world), frame_(frame_of(scene, world)), textures_(scene) {}

    PovrayFile write() {
        PovrayFile file;
        file.differences = differences(scene_, world_);
        std::string objects;
        for (std::size_t id = 0; id < scene_.drawn.size(); ++id) objects += object(id);
        file.text =
            head(file.differences) + settings() + camera() + lights() + textures_.declarations() + objects;
        return file;
    }

private:
    [[nodiscard]] std::string head(const std::vector<std::string>& differences) const {
        const std::string name = std::filesystem::path(scene_.file).filename().string();
        std::string text =
            comment(name + ", written by rayscope export, for POV-Ray 3.7. At the size of rayscope's image:");
        text += comment(fmt::format("  povray +IFILE.pov +W{} +H{} -A File_Gamma=sRGB", scene_.camera.width,
                                    scene_.camera.height));
        if (length(frame_.origin) > 0)
            text += comment("Moved by " + vector(-frame_.origin) + ", to keep digits.");
        if (frame_.scale != 1)
            text += comment("Scaled by " + number(frame_.scale) +
                            ": POV-Ray's shortest distance is fixed at 0.001.");
        if (!differences.empty()) text += comment("POV-Ray's image differs:");
        for (const std::string& difference : differences) text += comment("- " + difference);
        return text + '\n';
    }

    // Numbers are linear light; the file's gamma is the image's matter.
    [[nodiscard]] std::string settings() const {
        return fmt::format(
            "#version 3.7;\nglobal_settings {{\n  assumed_gamma 1\n  ambient_light {}\n  max_trace_level {}\n"
            "  adc_bailout {}\n}}\nbackground {{ {} }}\n",
            colour(scene_.ambient), std::min(scene_.limits.max_depth + 1, most_trace_levels),
            number(scene_.limits.min_weight), colour(scene_.background));
    }

    // Its own axes, so that no rule of handedness is needed.
    [[nodiscard]] std::string camera() const {
        const Camera& c = scene_.camera;
        const Vec3d forward = normalized(c.look_at - c.eye), right = normalized(cross(forward, c.up));
        const double height = 2 * std::tan(c.field_of_view * std::numbers::pi / 360);
        return fmt::format("camera {{\n  perspective\n  location {}\n  direction {}\n  right {} * "
                           "image_width / image_height\n"
                           "  up {}\n}}\n",
                           vector(frame_.point(c.eye)), vector(forward), vector(height * right),
                           vector(height * cross(right, forward)));
    }

    [[nodiscard]] std::string lights() const {
        // Farther than everything, and near enough for POV-Ray, which looks no farther than 10⁷.
        constexpr double sun_distance = 5e6;
        std::string text;
        for (const SceneLight& light : scene_.lights) {
            const Vec3d place =
                light.directional ? sun_distance * light.position : frame_.point(light.position);
            text += '\n' + comment(light.name);
            text += fmt::format("light_source {{ {}, {}{}{}{} }}\n", vector(place), colour(light.colour),
                                light.directional ? " parallel point_at 0" : "", area(light.area),
                                light.shadows || !casts_shadows(scene_) ? "" : " shadowless");
        }
        return text;
    }

    // A grid of points. A sphere shows each point the disk that faces it.
    [[nodiscard]] std::string area(const LightArea& area) const {
        if (!area.is_sampled()) return "";
        const bool round = area.shape != LightArea::Shape::rectangle;
        const double half = area.shape == LightArea::Shape::rectangle ? 1 : area.radius;
        const Vec3d u = area.shape == LightArea::Shape::sphere ? Vec3d{1, 0, 0} : area.u;
        const Vec3d v = area.shape == LightArea::Shape::sphere ? Vec3d{0, 1, 0} : area.v;
        const int rows = int(std::ceil(std::sqrt(area.samples)));
        return fmt::format(" area_light {}, {}, {}, {} area_illumination on{}{}",
                           vector(2 * half * frame_.scale * u), vector(2 * half * frame_.scale * v), rows,
                           rows, round ? " circular" : "",
                           area.shape == LightArea::Shape::sphere ? " orient" : "");
    }

    std::string object(std::size_t id) {
        const SceneObject& drawn = scene_.drawn[id];
        const Object& object = world_.objects[id];
        std::string modifiers = interior(id);
        if (!scene_.lights.empty() && !casts_shadows(scene_)) modifiers += " no_shadow";
        const std::string& name =
            drawn.is_compound ? scene_.compounds[drawn.index].name : scene_.generics[drawn.index].name;
        const std::string start = name.empty() ? "" : '\n' + comment(name);
        if (drawn.is_compound) return start + compound(scene_, drawn.index, frame_, textures_, modifiers);
        const SceneGeneric& generic = scene_.generics[drawn.index];
        modifiers = textures_.use(object.material, object.material, object.has_volume,
                                  frame_.matrix(generic.matrix)) +
                    modifiers;
        return start + shape(generic.shape, frame_.matrix(generic.matrix), modifiers);
    }

    // Beyond 1000 its power stands for exp(−(1 − fade_color) · way / fade_distance).
    [[nodiscard]] std::string fading(const Colour& absorption) const {
        const double most = largest_component(absorption);
        if (!(most > 0)) return "";
        return fmt::format(" fade_power 1001 fade_distance {} fade_color {}", number(frame_.scale / most),
                           colour(Colour{1} - absorption / most));
    }

    // POV-Ray's logarithm of the index is a straight line over the wavelength, from 380 to 730 nm: ours meets it at Gauss's
    // two points, where of all lines it has about the least mean square from the curve.
    [[nodiscard]] std::string spread(const Material& material) const {
        constexpr double middle = 555, width = 350;
        const double centre = (shortest_wavelength + longest_wavelength) / 2;
        const double aside = (longest_wavelength - shortest_wavelength) / (2 * std::numbers::sqrt3);
        const auto index = [&](double wavelength) {
            return std::log(world_.medium_speed / material.speed_at(wavelength));
        };
        const double slope = (index(centre + aside) - index(centre - aside)) / (2 * aside);
        return fmt::format(" interior {{ ior {} dispersion {} dispersion_samples {}{} }}",
                           number(std::exp(index(centre - aside) + slope * (middle - centre + aside))),
                           number(std::exp(-slope * width)), std::max(scene_.limits.wavelengths, 2),
                           fading(material.absorption));
    }

    // Only ratios of speeds bend rays: POV-Ray's space has index 1, whatever fills ours.
    [[nodiscard]] std::string interior(std::size_t id) const {
        const Object& object = world_.objects[id];
        const Material& material = world_.material_of(object);
        if (!material.transmits()) return "";
        if (object.has_volume && material.dispersion.spreads()) return spread(material);
        double index = object.has_volume ? world_.medium_speed / material.speed : 1;
        // A boundary that bends nothing would not count as a level of max_trace_level. These bend nothing that is seen,
        // and differ between most neighbours: by the last digits of a float, which is what POV-Ray keeps.
        constexpr std::size_t kinds = 31;
        if (index == 1) index += double(id % kinds + 1) / (1 << 23);
        return fmt::format(" interior {{ ior {}{} }}", number(index), fading(material.absorption));
    }

    const Scene& scene_;
    const WorldBase& world_;
    Frame frame_;
    Textures textures_;
};

} // namespace
} // namespace povray

PovrayFile to_povray(const Scene& scene, const WorldBase& world) {
    return povray::Exporter(scene, world).write();
}

} // namespace rayscope
