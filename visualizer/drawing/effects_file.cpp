#include "visualizer/drawing/effects_chart.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace rayscope::drawing {
namespace {

MeasuredEffect effect_of(const nlohmann::json& json) {
    MeasuredEffect effect;
    effect.name = json.at("effect").get<std::string>();
    effect.called_for = json.at("called_for").get<bool>();
    const auto& time = json.at("time_ratio");
    effect.time = time.at("median").get<double>();
    effect.least_time = time.at("least").get<double>();
    effect.greatest_time = time.at("greatest").get<double>();
    effect.difference = json.at("difference").get<double>();
    for (const double ratio : {effect.time, effect.least_time, effect.greatest_time})
        if (!(std::isfinite(ratio) && ratio > 0))
            throw std::runtime_error("expected numbers above 0 in 'time_ratio'");
    if (!(std::isfinite(effect.difference) && effect.difference >= 0))
        throw std::runtime_error("expected a number that is not below 0 in 'difference'");
    return effect;
}

} // namespace

EffectsFile read_effects(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(path.string(), {}, "can't be read");
    EffectsFile file;
    try {
        const auto json = nlohmann::json::parse(stream);
        file.scene = json.at("scene").get<std::string>();
        for (const auto& effect : json.at("effects")) file.effects.push_back(effect_of(effect));
    } catch (const std::exception& error) {
        throw InputError(path.string(), {}, error.what());
    }
    if (file.effects.empty()) throw InputError(path.string(), {}, "expected at least one effect, found none");
    return file;
}

void write_effects_chart(const std::filesystem::path& path, const PictureSize& size) {
    write_png(draw_effects_chart(read_effects(path), size), path.parent_path() / "effects.png");
}

} // namespace rayscope::drawing
