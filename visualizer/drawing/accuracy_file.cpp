#include "visualizer/drawing/accuracy_file.hpp"

#include "core/rayscope.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstring>
#include <fstream>

namespace rayscope::drawing {
namespace {

constexpr int largest_side = 32768;

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

ErrorMap read_error_map(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string magic;
    double scale = 0;
    ErrorMap map;
    file >> magic >> map.width >> map.height >> scale;
    if (!file || magic != "Pf" || map.width < 1 || map.height < 1 || map.width > largest_side ||
        map.height > largest_side || !(scale < 0))
        throw InputError(path.string(), {}, "expected a little-endian .pfm of one channel (Pf)");
    file.get();
    std::error_code error;
    const std::size_t pixels = std::size_t(map.width) * std::size_t(map.height);
    if (std::filesystem::file_size(path, error) - std::uintmax_t(file.tellg()) != pixels * sizeof(float))
        throw InputError(path.string(), {},
                         "expected " + std::to_string(pixels) + " numbers of 4 bytes after the header");
    map.values.resize(pixels);
    for (int y = map.height - 1; y >= 0; --y)
        file.read(reinterpret_cast<char*>(&map.values[std::size_t(y) * std::size_t(map.width)]),
                  std::streamsize(std::size_t(map.width) * sizeof(float)));
    return map;
}

} // namespace rayscope::drawing
