#include "visualizer/drawing/growth_chart.hpp"
#include "visualizer/drawing/write_png.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>

namespace rayscope::drawing {
namespace {

GrowthSeries series_of(const nlohmann::json& json) {
    GrowthSeries series;
    series.stage = json.at("stage").get<std::string>();
    series.rays = json.at("rays").get<std::string>();
    const auto& exponent = json.at("exponent");
    series.exponent = exponent.is_null() ? std::numeric_limits<double>::quiet_NaN() : exponent.get<double>();
    series.points = json.at("points").get<std::vector<std::pair<double, double>>>();
    if (series.points.empty()) throw std::runtime_error("expected at least one point, found none");
    for (const auto& [objects, time] : series.points)
        if (!(std::isfinite(objects) && objects > 0 && std::isfinite(time) && time > 0))
            throw std::runtime_error("expected numbers above 0 in 'points'");
    return series;
}

} // namespace

std::vector<GrowthSeries> read_growth(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw InputError(path.string(), {}, "can't be read");
    std::vector<GrowthSeries> list;
    try {
        const auto json = nlohmann::json::parse(file);
        for (const auto& series : json.at("growth")) list.push_back(series_of(series));
    } catch (const std::exception& error) {
        throw InputError(path.string(), {}, error.what());
    }
    if (list.empty()) throw InputError(path.string(), {}, "expected at least one series, found none");
    return list;
}

void write_growth_chart(const std::filesystem::path& path, const PictureSize& size) {
    write_png(draw_growth_chart(read_growth(path), size), path.parent_path() / "stages.png");
}

} // namespace rayscope::drawing
