#include "visualizer/drawing/accuracy_file.hpp"

#include "core/rayscope.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <fstream>

namespace rayscope::drawing {
namespace {

double positive(const nlohmann::json& json, const char* member) {
    const double value = json.at(member).get<double>();
    if (!std::isfinite(value) || value <= 0)
        throw std::runtime_error(std::string("expected '") + member + "' above 0");
    return value;
}

double not_negative(const nlohmann::json& json, const char* member) {
    const double value = json.at(member).get<double>();
    if (!(value >= 0)) throw std::runtime_error(std::string("expected '") + member + "' not below 0");
    return value;
}

MeasuredPoint point_of(const nlohmann::json& json) {
    MeasuredPoint p;
    p.name = json.at("name").get<std::string>();
    p.scalar = json.at("scalar").get<std::string>();
    p.method = json.at("method").get<std::string>();
    p.max_depth = json.at("max_depth").get<int>();
    p.min_weight = not_negative(json, "min_weight");
    const auto& seconds = json.at("seconds");
    p.seconds = positive(seconds, "median");
    p.fastest = positive(seconds, "min");
    p.slowest = positive(seconds, "max");
    p.relative_rmse = not_negative(json.at("errors"), "relative_rmse");
    p.on_front = json.at("on_front").get<bool>();
    p.map = json.value("map", std::string());
    if (std::filesystem::path(p.map).filename() != p.map)
        throw std::runtime_error("expected the name of a file beside this one in 'map', found '" + p.map +
                                 "'");
    return p;
}

AccuracyFile accuracy_of(const nlohmann::json& json) {
    if (json.at("format") != "rayscope-accuracy" || json.at("version") != 1)
        throw std::runtime_error("expected format rayscope-accuracy, version 1");
    AccuracyFile file;
    file.scene = json.at("scene").get<std::string>();
    file.width = json.at("image").at("width").get<int>();
    file.height = json.at("image").at("height").get<int>();
    file.floor = positive(json.at("reference"), "relative_rmse_floor");
    for (const auto& configuration : json.at("configurations"))
        file.points.push_back(point_of(configuration));
    if (file.points.empty()) throw std::runtime_error("expected at least one configuration, found none");
    file.sentences = json.value("sentences", std::vector<std::string>());
    return file;
}

} // namespace

AccuracyFile read_accuracy(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    if (!stream) throw InputError(path.string(), {}, "can't be read");
    try {
        return accuracy_of(nlohmann::json::parse(stream));
    } catch (const std::exception& error) {
        throw InputError(path.string(), {}, error.what());
    }
}

} // namespace rayscope::drawing
