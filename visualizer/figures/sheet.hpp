#pragma once
// A plane of the world on the page: figures whose rays lie in one plane are drawn in it, true to scale.

#include "visualizer/figures/svg.hpp"

namespace rayscope::figures {

struct Sheet {
    Vec3d origin{0}, right{1, 0, 0}, up{0, 1, 0}; ///< unit and square to each other
    Pixel at;                                     ///< where the origin stands on the page
    double scale = 100;                           ///< page units for a world unit

    [[nodiscard]] Pixel operator()(const Vec3d& p) const {
        return {at.x + scale * dot(p - origin, right), at.y - scale * dot(p - origin, up)};
    }
    /// The same point plus so many page units.
    [[nodiscard]] Pixel operator()(const Vec3d& p, double x, double y) const {
        const Pixel there = (*this)(p);
        return {there.x + x, there.y + y};
    }
    /// Angle of a direction on the page: from the right towards the top.
    [[nodiscard]] double angle(const Vec3d& d) const { return std::atan2(dot(d, up), dot(d, right)); }
};

/// An inside list, by its ends.
using List = std::vector<std::pair<double, double>>;

/// The scene with these of its generics drawn in place of what it draws, in this order.
[[nodiscard]] Workbench apart(const Scene& scene, const std::vector<std::string>& generics);

/// Which of the scene's drawn objects has this name. Throws InputError where none has.
[[nodiscard]] std::size_t drawn_called(const Scene& scene, const std::string& name);

/// The inside list of a drawn object on the line of a ray.
[[nodiscard]] List list_of(const Workbench& bench, const Ray<double>& ray, std::size_t drawn = 0);

/// The inside list of a node in a trace, by the node's name (the root: its object's).
[[nodiscard]] List list_of(const Trace& trace, int ray, const std::string& node);

/// Where any function of inside lists holds, between the least and the greatest end of all.
template <typename Holds>
[[nodiscard]] List combined(const std::vector<List>& lists, double low, double high, const Holds& holds) {
    std::vector<double> ends{low, high};
    for (const List& list : lists)
        for (const auto& [enter, exit] : list)
            for (const double t : {enter, exit})
                if (t > low && t < high) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    List result;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const double middle = (ends[i] + ends[i + 1]) / 2;
        std::vector<bool> inside;
        for (const List& list : lists)
            inside.push_back(std::any_of(list.begin(), list.end(), [&](const auto& s) {
                return s.first < middle && middle < s.second;
            }));
        if (!(ends[i] < ends[i + 1]) || !holds(inside)) continue;
        if (!result.empty() && result.back().second == ends[i])
            result.back().second = ends[i + 1];
        else
            result.emplace_back(ends[i], ends[i + 1]);
    }
    return result;
}

/// What a plane cuts out of a solid, as outlines to fill: `lists` tells where the ray of a row, along `right`, is inside.
/// Each row of the page's units asks for itself; low and high are distances from the origin along `up`.
template <typename Lists>
[[nodiscard]] std::vector<std::vector<Pixel>> section(const Sheet& plane, double low, double high,
                                                      const Lists& lists) {
    struct Run {
        std::vector<Pixel> left, right;
        std::pair<double, double> last;
    };
    std::vector<Run> open;
    std::vector<std::vector<Pixel>> done;
    const auto add = [](Run& run, double x0, double x1, double y) {
        run.left.push_back({x0, y});
        run.right.push_back({x1, y});
    };
    const auto close = [&](Run& run) {
        run.left.insert(run.left.end(), run.right.rbegin(), run.right.rend());
        done.push_back(std::move(run.left));
    };
    const auto meet = [](const std::pair<double, double>& a, const std::pair<double, double>& b) {
        return a.first < b.second && b.first < a.second;
    };
    const auto page_x = [&](double along) { return plane.at.x + plane.scale * along; };
    const int rows = int((high - low) * plane.scale);
    for (int i = 0; i < rows; ++i) {
        const double height = high - (i + 0.5) / plane.scale, y = plane.at.y - plane.scale * height;
        const List spans = lists(Ray<double>{plane.origin + plane.up * height, plane.right});
        const bool same = spans.size() == open.size() &&
                          std::equal(spans.begin(), spans.end(), open.begin(),
                                     [&](const auto& s, const Run& run) { return meet(s, run.last); });
        if (!same) {
            std::vector<Run> begun(spans.size());
            // Where the number of spans changes, what goes on meets halfway between the rows; a tip stays one.
            for (std::size_t k = 0; k < spans.size(); ++k)
                if (std::any_of(open.begin(), open.end(),
                                [&](const Run& run) { return meet(run.last, spans[k]); }))
                    add(begun[k], page_x(spans[k].first), page_x(spans[k].second), y - 0.5);
            for (Run& run : open) {
                if (std::any_of(spans.begin(), spans.end(), [&](const auto& s) { return meet(run.last, s); }))
                    add(run, page_x(run.last.first), page_x(run.last.second), y - 0.5);
                close(run);
            }
            open = std::move(begun);
        }
        for (std::size_t k = 0; k < spans.size(); ++k) {
            add(open[k], page_x(spans[k].first), page_x(spans[k].second), y);
            open[k].last = spans[k];
        }
    }
    for (Run& run : open) close(run);
    return done;
}

} // namespace rayscope::figures
