#include "core/accuracy/report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rayscope {
namespace {

nlohmann::ordered_json json_of(const Measured& m) {
    const ImageError& e = m.error;
    nlohmann::ordered_json json;
    json["name"] = name_of(m.configuration);
    json["scalar"] = scalar_name(m.configuration.numbers.scalar);
    json["method"] = method_name(m.configuration.numbers.method);
    json["max_depth"] = m.configuration.max_depth;
    json["min_weight"] = m.configuration.min_weight;
    json["seconds"] = {{"median", m.seconds.median},
                       {"min", m.seconds.min},
                       {"max", m.seconds.max},
                       {"runs", m.seconds.runs}};
    json["errors"] = {{"wrong_pixels", e.wrong_pixels},
                      {"t_max", e.t_max},
                      {"t_rms", e.t_rms},
                      {"relative_rmse", e.relative_rmse},
                      {"delta_e_mean", e.delta_e_mean},
                      {"delta_e_max", e.delta_e_max},
                      {"psnr", e.psnr ? nlohmann::ordered_json(*e.psnr) : nlohmann::ordered_json(nullptr)},
                      {"energy_lost", e.energy_lost}};
    json["on_front"] = m.on_front;
    if (!m.map.empty()) json["map"] = m.map;
    return json;
}

std::string psnr_text(const ImageError& error) {
    return error.psnr ? fmt::format("{:.1f}", *error.psnr) : "same";
}

} // namespace

std::string accuracy_table(const AccuracyReport& report) {
    if (report.list.empty()) return {};
    std::size_t width = 13;
    for (const Measured& m : report.list) width = std::max(width, name_of(m.configuration).size());
    const double unit = report.list.front().seconds.median;
    std::string text = fmt::format("{:<{}}  {:>9}  {:>6}  {:>7}  {:>6}  {:>9}  {:>9}  {:>7}  {:>6}  {:>7}\n",
                                   "configuration", width, "ms", "spread", "× first", "wrong", "max |Δt|",
                                   "rel. RMSE", "ΔE2000", "PSNR", "lost");
    for (const Measured& m : report.list) {
        const ImageError& e = m.error;
        const double spread = (m.seconds.max - m.seconds.min) / m.seconds.median / 2;
        text +=
            fmt::format("{:<{}}  {:>9.2f}  ±{:>4.0f}%  {:>7.2f}  {:>6}  {:>9.2g}  {:>9.2g}  {:>7.3f}  {:>6}"
                        "  {:>6.2f}%{}\n",
                        name_of(m.configuration), width, 1000 * m.seconds.median, 100 * spread,
                        m.seconds.median / unit, e.wrong_pixels, e.t_max, e.relative_rmse, e.delta_e_mean,
                        psnr_text(e), 100 * e.energy_lost, m.on_front ? "  ◄ front" : "");
    }
    const Reference& r = report.reference;
    text += fmt::format(
        "\n{} × {} pixels; time of tracing, median of {} runs in turn, processor time.\n"
        "reference: float128 stable, depth {}, weight {:g}, at most {} rays a pixel; a pixel lacks "
        "at most {:.2g} (mean {:.2g}), so a relative RMSE below {:.2g} says nothing.\n\n",
        r.width, r.height, report.list.front().seconds.runs, r.limits.max_depth, r.limits.min_weight,
        r.limits.max_rays, r.uncertainty_max, r.uncertainty_mean, r.relative_rmse_floor);
    for (const std::string& sentence : report.sentences) text += sentence + "\n";
    return text;
}

std::string accuracy_csv(const AccuracyReport& report) {
    std::string text =
        "scalar,method,max_depth,min_weight,seconds_median,seconds_min,seconds_max,runs,wrong_pixels,"
        "t_max,t_rms,relative_rmse,delta_e_mean,delta_e_max,psnr,energy_lost,on_front\n";
    for (const Measured& m : report.list) {
        const ImageError& e = m.error;
        text += fmt::format(
            "{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
            scalar_name(m.configuration.numbers.scalar), method_name(m.configuration.numbers.method),
            m.configuration.max_depth, m.configuration.min_weight, m.seconds.median, m.seconds.min,
            m.seconds.max, m.seconds.runs, e.wrong_pixels, e.t_max, e.t_rms, e.relative_rmse, e.delta_e_mean,
            e.delta_e_max, e.psnr ? fmt::format("{}", *e.psnr) : "inf", e.energy_lost, m.on_front ? 1 : 0);
    }
    return text;
}

std::string accuracy_json(const AccuracyReport& report) {
    const Reference& r = report.reference;
    nlohmann::ordered_json json;
    json["format"] = "rayscope-accuracy";
    json["version"] = 1;
    json["scene"] = report.scene;
    json["image"] = {{"width", r.width}, {"height", r.height}};
    json["reference"] = {{"scalar", "float128"},
                         {"method", "stable"},
                         {"max_depth", r.limits.max_depth},
                         {"min_weight", r.limits.min_weight},
                         {"max_rays", r.limits.max_rays},
                         {"uncertainty", {{"mean", r.uncertainty_mean}, {"max", r.uncertainty_max}}},
                         {"relative_rmse_floor", r.relative_rmse_floor}};
    json["configurations"] = nlohmann::ordered_json::array();
    for (const Measured& m : report.list) json["configurations"].push_back(json_of(m));
    json["sentences"] = report.sentences;
    return json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

} // namespace rayscope
