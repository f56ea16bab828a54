// Measured times of each stage as the number of objects grows.

#include "visualizer/figures/figures.hpp"
#include "visualizer/figures/lanes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace rayscope::figures {
namespace {

struct StageTime {
    std::string stage, rays;
    double objects = 0, nanoseconds = 0;
};

/// growth.csv: stage,rays,objects,nanoseconds, after one line of heads. Its rows are taken from the stages.csv that
/// `rayscope bench stages --scenes cloud` writes: of each stage the rays that it is there for.
std::vector<StageTime> read_growth_table(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string line;
    if (!file || !std::getline(file, line)) throw InputError(path.string(), {}, "can't be read");
    std::vector<StageTime> list;
    for (int number = 2; std::getline(file, line); ++number) {
        std::istringstream words(line);
        StageTime row;
        char comma = 0;
        if (!std::getline(words, row.stage, ',') || !std::getline(words, row.rays, ',') ||
            !(words >> row.objects >> comma >> row.nanoseconds) || comma != ',' || !(row.objects > 0) ||
            !(row.nanoseconds > 0))
            throw InputError(path.string(), Place{number, 1},
                             "expected stage,rays,objects,nanoseconds, both numbers above 0");
        list.push_back(row);
    }
    if (list.empty()) throw InputError(path.string(), Place{2, 1}, "expected at least one measurement");
    return list;
}

/// Colour and mark both tell a stage.
struct Look {
    const char* stage;
    Rgb colour;
    int corners; ///< of the mark; 0: a dot
    const char* dash;
};

void draw_stage_mark(Svg& svg, Pixel at, const Look& look) {
    if (look.corners == 0) return svg.dot(at, 8, look.colour);
    std::vector<Pixel> points;
    for (int i = 0; i < look.corners; ++i) {
        const double angle = 2 * M_PI * i / look.corners + (look.corners == 4 ? M_PI / 4 : M_PI / 2);
        points.push_back({at.x + 10 * std::cos(angle), at.y - 10 * std::sin(angle)});
    }
    svg.area(points, {look.colour});
}

std::string power_of_ten(int exponent) {
    constexpr std::array digits_above{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    return std::string("10") + digits_above[std::size_t(exponent)];
}

} // namespace

Svg time_against_n(const Subject& subject) {
    constexpr std::array looks{Look{"scan", black, 4, ""},           Look{"extents", vermilion, 3, "10 5"},
                               Look{"projective", purple, 6, "2 5"}, Look{"octree", blue, 0, ""},
                               Look{"bvh", green, 5, "4 5"},         Look{"light", orange, 8, "14 4 2 4"}};
    const auto all = read_growth_table(subject.chapters / "06_octree" / "growth.csv");
    double least = infinity<double>, most = 0, slowest = 0, quickest = infinity<double>;
    for (const StageTime& m : all) {
        least = std::min(least, m.objects);
        most = std::max(most, m.objects);
        quickest = std::min(quickest, m.nanoseconds);
        slowest = std::max(slowest, m.nanoseconds);
    }
    const int left = int(std::lround(std::log10(least))), right = int(std::lround(std::log10(most)));
    const int low = int(std::floor(std::log10(quickest))), high = int(std::ceil(std::log10(slowest)));
    Svg svg(1000, 784);
    const drawing::Area plot{100, 40, 660, 580};
    const auto place = [&](double objects, double time) {
        return Pixel{plot.x + plot.width * (std::log10(objects) - left) / (right - left),
                     plot.bottom() - plot.height * (std::log10(time) - low) / (high - low)};
    };
    for (int i = left; i <= right; ++i) {
        const double x = place(std::pow(10, i), 1).x;
        svg.line({x, plot.y}, {x, plot.bottom()}, {pale, 2});
        svg.text({x, plot.bottom() + 24}, power_of_ten(i), {20});
    }
    for (int i = low; i <= high; ++i) {
        const double y = place(1, std::pow(10, i)).y;
        svg.line({plot.x, y}, {plot.right(), y}, {pale, 2});
        svg.text({plot.x - 14, y}, power_of_ten(i), {20, black, false, Anchor::end});
    }
    svg.text({plot.x, 16}, "time for a ray, ns", {20, black, true, Anchor::start});
    svg.text({plot.x + plot.width / 2, plot.bottom() + 58}, "number of objects, N", {20, black, true});
    struct Name {
        Pixel end;
        std::string words;
        Rgb colour;
    };
    std::vector<Name> names;
    for (const Look& look : looks) {
        std::vector<StageTime> own;
        std::copy_if(all.begin(), all.end(), std::back_inserter(own),
                     [&](const StageTime& m) { return m.stage == look.stage; });
        if (own.empty()) continue;
        std::vector<Pixel> points;
        points.reserve(own.size());
        for (const StageTime& m : own) points.push_back(place(m.objects, m.nanoseconds));
        svg.path(points, {look.colour, 3.5, look.dash});
        for (const Pixel& point : points) draw_stage_mark(svg, point, look);
        const double times = own.back().nanoseconds / own.front().nanoseconds;
        names.push_back({points.back(), std::string(look.stage) + " × " + digits(times, times < 10 ? 1 : 0),
                         look.colour});
    }
    // Within the plot, above a line of its grid that would go through it.
    const double row = plot.height / (high - low);
    for (Name& name : names) {
        const double above = std::remainder(plot.bottom() - name.end.y, row);
        if (name.end.x < plot.right() && std::abs(above) < 18) name.end.y -= 18 - above;
    }
    // From below upwards, none over another.
    std::sort(names.begin(), names.end(), [](const Name& a, const Name& b) { return a.end.y > b.end.y; });
    double free = infinity<double>;
    for (const Name& name : names) {
        const double y = std::min(name.end.y, free);
        svg.text({name.end.x + 22, y}, name.words, {20, name.colour, true, Anchor::start});
        free = y - 28;
    }
    svg.text({500, 758}, "projective: eye rays; light: shadow rays; the others: rays into random directions",
             {19});
    svg.text({500, 728},
             "× 10: at the last mark a ray takes 10 times as long as for " + power_of_ten(left) + " objects",
             {19});
    return svg;
}

} // namespace rayscope::figures
