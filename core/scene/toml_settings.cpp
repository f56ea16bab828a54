// Camera, lights, and the sections without names.

#include "core/scene/toml_optics.hpp"
#include "core/scene/toml_sections.hpp"
#include "core/scene/view_check.hpp"

#include <fmt/format.h>

namespace rayscope {
namespace {

void read_resolution(const TomlValue& value, Camera& camera) {
    const auto sides = value.list(2, "[width, height]");
    camera.width = sides[0].integer(1, largest_side);
    camera.height = sides[1].integer(1, largest_side);
    if (double(camera.width) * camera.height > most_pixels)
        value.fail(
            fmt::format("'resolution': {} × {} are more than 10^8 pixels", camera.width, camera.height));
}

SceneLight read_light(const TomlEntry& entry, bool shadows_by_default) {
    const TomlTable table = entry.value.table();
    std::vector<std::string_view> keys{"position", "direction", "colour", "shadows"};
    keys.insert(keys.end(), area_keys.begin(), area_keys.end());
    table.allow_only("a light", keys);
    table.allow_one("position", "direction");
    SceneLight light;
    light.shadows = shadows_by_default;
    light.name = entry.key;
    light.place = entry.place;
    if (const auto direction = table.find("direction")) {
        const Vec3d travels = direction->vector();
        if (length(travels) == 0) direction->fail("'direction' has length zero");
        light.directional = true;
        light.position = -normalized(travels);
    } else {
        light.position = table.require("position", entry.place, "position = [4, 3, 2]").vector();
    }
    if (const auto colour = table.find("colour")) light.colour = colour->colour(not_negative);
    if (const auto shadows = table.find("shadows")) light.shadows = shadows->boolean();
    read_area(table, light);
    return light;
}

void read_surroundings(const TomlTable& table, Scene& scene) {
    table.allow_only("[scene]", {"background", "ambient", "shadows", "media", "medium", "effects"});
    if (const auto background = table.find("background")) scene.background = background->colour(not_negative);
    if (const auto ambient = table.find("ambient")) scene.ambient = ambient->colour(not_negative);
    if (const auto shadows = table.find("shadows")) scene.shadows = shadows->boolean();
    if (const auto media = table.find("media")) scene.notes_media = media->choice({"priority", "notes"}) == 1;
    if (const auto medium = table.find("medium")) {
        medium->table().allow_only("a medium", {"speed", "index"});
        scene.medium_speed = read_speed(medium->table()).value_or(scene.medium_speed);
    }
    if (const auto effects = table.find("effects")) scene.effects = read_effects(*effects);
}

void read_limits(const TomlTable& table, Limits& limits) {
    table.allow_only("[limits]", {"max_depth", "min_weight", "max_rays", "wavelengths"});
    if (const auto depth = table.find("max_depth")) limits.max_depth = depth->integer(0, 256);
    if (const auto weight = table.find("min_weight")) limits.min_weight = weight->number(from_0_to_1);
    if (const auto rays = table.find("max_rays")) limits.max_rays = rays->integer(1, 1000000000);
    if (const auto lines = table.find("wavelengths")) limits.wavelengths = lines->integer(1, 64);
}

void read_step(const TomlTable& table, Scene& scene) {
    table.allow_only("[step]", {"pixel"});
    if (const auto pixel = table.find("pixel")) {
        const auto parts = pixel->list(2, "[x, y]");
        scene.step_pixel = {parts[0].integer(0, scene.camera.width - 1),
                            parts[1].integer(0, scene.camera.height - 1)};
    }
}

} // namespace

void read_camera(const TomlTable& root, Scene& scene) {
    const auto section = root.find("camera");
    if (!section) return;
    const TomlTable table = section->table();
    table.allow_only("[camera]", {"eye", "look_at", "up", "field_of_view", "resolution", "samples"});
    Camera& camera = scene.camera;
    if (const auto eye = table.find("eye")) camera.eye = eye->vector();
    if (const auto look_at = table.find("look_at")) camera.look_at = look_at->vector();
    if (const auto up = table.find("up")) camera.up = up->vector();
    if (const auto angle = table.find("field_of_view")) camera.field_of_view = angle->number({0, 180, true});
    if (const auto samples = table.find("samples")) {
        camera.samples = samples->integer(1, most_samples);
        scene.samples_place = samples->place();
    }
    if (const auto resolution = table.find("resolution")) read_resolution(*resolution, camera);
    // Of the three keys that make the view, blame one that is written.
    const auto blamed = table.find("up")    ? table.find("up")
                        : table.find("eye") ? table.find("eye")
                                            : table.find("look_at");
    if (const auto problem = view_problem(camera))
        root.source().fail(blamed ? blamed->place() : section->place(), *problem);
}

void read_lights(const TomlTable& root, Scene& scene) {
    if (const auto section = root.find("lights"))
        for (const TomlEntry& entry : section->table().named_entries("a light"))
            scene.lights.push_back(read_light(entry, scene.shadows));
}

void read_settings(const TomlTable& root, Scene& scene) {
    if (const auto section = root.find("scene")) read_surroundings(section->table(), scene);
    if (const auto section = root.find("limits")) read_limits(section->table(), scene.limits);
    if (const auto section = root.find("step")) read_step(section->table(), scene);
}

} // namespace rayscope
