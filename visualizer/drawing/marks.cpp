#include "visualizer/drawing/marks.hpp"

#include "visualizer/drawing/text.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

namespace rayscope::drawing {
namespace {

constexpr Rgb light_text{0x80, 0x60, 0x00};

class Marks {
public:
    Marks(Canvas& canvas, LabelPlacer& placer, const Region& region, const View& view, double font)
        : canvas_(canvas), placer_(placer), region_(region), view_(view), font_(font) {}

    void eye(const Trace& trace) {
        if (trace.rays.empty()) return;
        const Vec3d world = trace.rays.front().start().origin;
        const Vec3d origin = view_.to_view(world);
        const std::string name = trace.source.by_hand ? "start" : "eye";
        if (const auto at = inside(origin)) {
            const double r = font_ * 0.42;
            canvas_.add(Disc{*at, r, ink});
            canvas_.add(Disc{*at, r * 0.62, paper});
            canvas_.add(Disc{*at, r * 0.36, ink});
            placer_.reserve({at->x - r, at->y - r, 2 * r, 2 * r});
            placer_.place(canvas_, {name, *at, ink, font_, Font::bold, r + 3});
            return;
        }
        const Vec3d ahead = normalized(trace.rays.front().start().direction);
        const Vec3d to = origin + ahead * (length(origin) * 2 + 2);
        const auto part = view_.visible(origin, to, font_);
        const Vec3d entry = part ? origin + (to - origin) * part->from : origin;
        if (const auto at = part ? view_.pixel(entry) : std::nullopt)
            placer_.place(
                canvas_, {fmt::format("{}, {} away", name, number(length(origin - entry) * view_.scale(), 3)),
                          *at, ink, font_, Font::bold, font_ * 0.7});
    }

    void light(const TraceLight& light, std::size_t index) {
        std::string name = light.name.empty() ? fmt::format("light {}", index) : light.name;
        const Vec3d at_view = light.directional ? Vec3d{0} : view_.to_view(light.position);
        if (const auto at = light.directional ? std::nullopt : inside(at_view)) {
            sun(*at);
            waiting_.push_back({name, *at, light_text, font_, Font::bold, font_});
            return;
        }
        const Vec3d direction = light.directional ? light.position : normalized(at_view);
        const auto from = view_.pixel({}), towards = view_.pixel(direction * 0.2);
        if (!from || !towards) return;
        const double dx = towards->x - from->x, dy = towards->y - from->y, size = std::hypot(dx, dy);
        if (!(size > 0)) return;
        const Pixel tip = border({dx / size, dy / size});
        arrow(tip, {dx / size, dy / size});
        if (light.directional)
            name += " (direction)";
        else
            name = fmt::format("{}, {} away", name, number(length(light.position - region_.centre), 3));
        waiting_.push_back({name,
                            {tip.x - dx / size * font_, tip.y - dy / size * font_},
                            light_text,
                            font_,
                            Font::bold,
                            font_ * 0.9});
    }

    /// The lights' names, once all their marks have a place.
    void name_lights() {
        for (const Label& label : waiting_) placer_.place(canvas_, label);
    }

    void hit(const Trace& trace, const RayStyle& style) {
        const auto* chosen = trace.rays[std::size_t(style.ray)].find<BoundaryChosen>();
        if (chosen == nullptr) return;
        const auto at = inside(view_.to_view(chosen->point));
        if (!at) return;
        const bool path = style.emphasis == Emphasis::path;
        placer_.place(canvas_, {fmt::format("P{}", style.ray), *at, mixed(hit_purple, ink, 0.35),
                                font_ * 0.95, path ? Font::bold : Font::sans, font_ * 0.55});
    }

    void surface(const Surface& surface, const Workbench& bench) {
        const auto at = surface.flat ? on_floor(surface) : on_top(bench.world.objects[surface.drawn].bounds);
        if (at)
            placer_.place(canvas_, {elided(surface.name, Font::sans, font_, font_ * 14), *at, quiet_ink,
                                    font_, Font::sans, font_ * 0.4});
    }

private:
    [[nodiscard]] std::optional<Pixel> inside(const Vec3d& point) const {
        const auto at = view_.pixel(point);
        const Area& a = view_.area();
        if (!at || at->x < a.x + 2 || at->x > a.right() - 2 || at->y < a.y + 2 || at->y > a.bottom() - 2)
            return std::nullopt;
        return at;
    }

    /// Where a line from the middle in this direction meets the border.
    [[nodiscard]] Pixel border(const Pixel& direction) const {
        const Area& a = view_.area();
        const double inset = font_ * 0.6;
        const double wide = a.width / 2 - inset, high = a.height / 2 - inset;
        const double reach = std::min(direction.x != 0 ? wide / std::abs(direction.x) : infinity<double>,
                                      direction.y != 0 ? high / std::abs(direction.y) : infinity<double>);
        return {a.x + a.width / 2 + direction.x * reach, a.y + a.height / 2 + direction.y * reach};
    }

    void sun(const Pixel& at) {
        const double r = font_ * 0.42;
        for (int i = 0; i < 8; ++i) {
            const double angle = i * std::numbers::pi / 4, c = std::cos(angle), s = std::sin(angle);
            canvas_.add(
                Stroke{{{at.x + c * r * 1.35, at.y + s * r * 1.35}, {at.x + c * r * 2, at.y + s * r * 2}},
                       light_text,
                       1.4});
        }
        canvas_.add(Disc{at, r + 1, light_text});
        canvas_.add(Disc{at, r, light_yellow});
        placer_.reserve({at.x - 2 * r, at.y - 2 * r, 4 * r, 4 * r});
    }

    void arrow(const Pixel& tip, const Pixel& d) {
        const double size = font_ * 1.5, half = font_ * 0.5;
        const Pixel tail{tip.x - d.x * size * 1.7, tip.y - d.y * size * 1.7};
        const Pixel neck{tip.x - d.x * size * 0.8, tip.y - d.y * size * 0.8};
        canvas_.add(Stroke{{tail, neck}, light_text, 3});
        canvas_.add(FilledPolygon{
            {tip, {neck.x - d.y * half, neck.y + d.x * half}, {neck.x + d.y * half, neck.y - d.x * half}},
            light_text});
        placer_.reserve({std::min(tip.x, tail.x) - 3, std::min(tip.y, tail.y) - 3,
                         std::abs(tip.x - tail.x) + 6, std::abs(tip.y - tail.y) + 6});
    }

    /// The highest point of a box, as seen.
    [[nodiscard]] std::optional<Pixel> on_top(const Box<double>& box) const {
        if (!box.bounded()) return std::nullopt;
        const Vec3d middle = box.low + (box.high - box.low) / 2.0, half = (box.high - box.low) / 2.0;
        const Vec3d u = absolute(view_.up());
        const int axis = u.x > u.y && u.x > u.z ? 0 : (u.y > u.z ? 1 : 2);
        Vec3d top = middle;
        top[axis] += half[axis] * (view_.up()[axis] < 0 ? -1 : 1);
        return inside(view_.to_view(top));
    }

    /// A place on a patch towards the lower border of the picture.
    [[nodiscard]] std::optional<Pixel> on_floor(const Surface& surface) const {
        if (surface.pieces.empty()) return std::nullopt;
        std::optional<Pixel> best;
        double best_score = -infinity<double>;
        const auto& piece = surface.pieces.front();
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            const Vec3d p = view_.to_view(point_of(piece, i));
            if (length(p) > 1.35) continue;
            const auto at = inside(p);
            if (!at) continue;
            const double score = at->x - 0.6 * at->y;
            if (score > best_score) {
                best_score = score;
                best = at;
            }
        }
        return best;
    }

    Canvas& canvas_;
    LabelPlacer& placer_;
    const Region& region_;
    const View& view_;
    double font_;
    std::vector<Label> waiting_;
};

} // namespace

void draw_marks(Canvas& canvas, LabelPlacer& placer, const Trace& trace, const std::vector<RayStyle>& styles,
                const Surfaces& surfaces, const Workbench& bench, const Region& region, const View& view,
                double font) {
    Marks marks(canvas, placer, region, view, font);
    for (std::size_t i = 0; i < std::min<std::size_t>(trace.lights.size(), 6); ++i)
        marks.light(trace.lights[i], i);
    marks.eye(trace);
    marks.name_lights();
    constexpr std::size_t most_labels = 24;
    for (std::size_t i = 0, placed = 0; i < styles.size() && placed < most_labels; ++i) {
        if (styles[i].emphasis == Emphasis::ghost) break;
        if (trace.rays[std::size_t(styles[i].ray)].find<BoundaryChosen>() == nullptr) continue;
        marks.hit(trace, styles[i]);
        ++placed;
    }
    std::size_t named = 0;
    for (const Surface& surface : surfaces.shown)
        if (surface.hit && !surface.room && named++ < 12) marks.surface(surface, bench);
}

} // namespace rayscope::drawing
