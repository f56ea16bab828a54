#include "visualizer/drawing/accuracy_chart.hpp"

#include "visualizer/drawing/flat_picture.hpp"
#include "visualizer/drawing/log_axis.hpp"
#include "visualizer/drawing/placed_names.hpp"
#include "visualizer/drawing/text.hpp"

#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace rayscope::drawing {
namespace {

constexpr std::array<Rgb, 5> series_colours{Rgb{0x00, 0x72, 0xB2}, Rgb{0xD5, 0x5E, 0x00},
                                            Rgb{0x00, 0x9E, 0x73}, Rgb{0xAA, 0x3C, 0x84},
                                            Rgb{0x66, 0x66, 0x66}};
constexpr std::array<const char*, 4> series_scalars{"float", "double", "long double", "float128"};

Rgb colour_of(const std::string& scalar) {
    const auto found = std::find(series_scalars.begin(), series_scalars.end(), scalar);
    return series_colours.at(std::size_t(found - series_scalars.begin()));
}

// What a configuration has otherwise than the first, which is the scene's own.
std::string short_name(const MeasuredPoint& point, const MeasuredPoint& own) {
    if (&point == &own) return "the scene's own";
    std::string name;
    const auto add = [&](bool different, const std::string& text) {
        if (different) name += (name.empty() ? "" : ", ") + text;
    };
    add(point.scalar != own.scalar || point.method != own.method, point.scalar + " " + point.method);
    add(point.max_depth != own.max_depth, "depth " + std::to_string(point.max_depth));
    add(point.min_weight != own.min_weight, "weight " + number(point.min_weight));
    return name.empty() ? point.name : name;
}

// The properties that text_property gives are those of a text that stands at its lower left corner.
void place_texts(vtkAxis* axis, bool upright) {
    for (vtkTextProperty* text : {axis->GetLabelProperties(), axis->GetTitleProperties()}) {
        text->SetJustificationToCentered();
        text->SetVerticalJustificationToTop();
    }
    if (!upright) return;
    axis->GetLabelProperties()->SetJustificationToRight();
    axis->GetLabelProperties()->SetVerticalJustificationToCentered();
    axis->GetTitleProperties()->SetVerticalJustificationToBottom();
    axis->GetTitleProperties()->SetOrientation(90);
}

class AccuracyChart {
public:
    AccuracyChart(const AccuracyFile& file, const PictureSize& size)
        : file_(file), size_(size), font_(std::max(12.0, size.height / 62.0)), picture_(size) {}

    [[nodiscard]] Raster draw() {
        lay_out();
        add_front();
        add_points();
        picture_.scene()->AddItem(chart_);
        picture_.render(); // now the axes know their pixels
        draw_floor();
        draw_labels();
        draw_texts();
        return picture_.finish(std::move(canvas_));
    }

private:
    [[nodiscard]] double milliseconds(const MeasuredPoint& p) const { return 1000 * p.seconds; }
    [[nodiscard]] double error(const MeasuredPoint& p) const {
        return std::max(p.relative_rmse, file_.floor);
    }

    void lay_out() {
        double least_time = infinity<double>, most_time = 0, least_error = file_.floor,
               most_error = file_.floor;
        for (const MeasuredPoint& p : file_.points) {
            least_time = std::min(least_time, milliseconds(p));
            most_time = std::max(most_time, milliseconds(p));
            most_error = std::max(most_error, error(p));
        }
        const LogAxis time(least_time, most_time), errors(least_error, most_error);
        for (const int position : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
            vtkAxis* axis = chart_->GetAxis(position);
            (position == vtkAxis::BOTTOM ? time : errors).apply(axis);
            const auto text = text_property(Font::sans, font_ * FlatPicture::scale, ink);
            axis->GetLabelProperties()->ShallowCopy(text);
            axis->GetTitleProperties()->ShallowCopy(text);
            place_texts(axis, position == vtkAxis::LEFT);
            axis->GetGridPen()->SetColor(hair.red, hair.green, hair.blue);
        }
        chart_->GetAxis(vtkAxis::BOTTOM)->SetTitle("time to trace the image: processor milliseconds");
        chart_->GetAxis(vtkAxis::LEFT)->SetTitle("error: relative RMSE");
        chart_->SetAutoSize(false);
        const double below = font_ * (2 + 1.5 * double(file_.sentences.size())), above = font_ * 5;
        chart_->SetSize(vtkRectf(0, float(below * FlatPicture::scale),
                                 float((size_.width - font_) * FlatPicture::scale),
                                 float((size_.height - below - above) * FlatPicture::scale)));
    }

    vtkSmartPointer<vtkTable> table_of(const std::vector<const MeasuredPoint*>& points) const {
        auto table = vtkSmartPointer<vtkTable>::New();
        vtkNew<vtkDoubleArray> x, y;
        x->SetName("time");
        y->SetName("error");
        for (const MeasuredPoint* p : points) {
            x->InsertNextValue(std::log10(milliseconds(*p)));
            y->InsertNextValue(std::log10(error(*p)));
        }
        table->AddColumn(x);
        table->AddColumn(y);
        return table;
    }

    [[nodiscard]] std::vector<const MeasuredPoint*> front_points() const {
        std::vector<const MeasuredPoint*> front;
        for (const MeasuredPoint& p : file_.points)
            if (p.on_front) front.push_back(&p);
        std::sort(front.begin(), front.end(),
                  [](const auto* a, const auto* b) { return a->seconds < b->seconds; });
        return front;
    }

    void add_front() {
        const auto front = front_points();
        if (front.size() < 2) return; // a line has two ends
        vtkNew<vtkPlotLine> line;
        line->SetInputData(table_of(front), 0, 1);
        line->SetColor(quiet_ink.red, quiet_ink.green, quiet_ink.blue, 255);
        line->SetWidth(float(1.5 * FlatPicture::scale));
        chart_->AddPlot(line);
    }

    // One series for each scalar and method: colour tells the one, shape the other.
    void add_points() {
        std::map<std::pair<std::string, std::string>, std::vector<const MeasuredPoint*>> series;
        for (const MeasuredPoint& p : file_.points) series[{p.scalar, p.method}].push_back(&p);
        for (const auto& [kind, points] : series) {
            vtkNew<vtkPlotPoints> plot;
            const Rgb colour = colour_of(kind.first);
            plot->SetInputData(table_of(points), 0, 1);
            plot->SetColor(colour.red, colour.green, colour.blue, 255);
            plot->SetMarkerStyle(kind.second == "stable" ? vtkPlotPoints::CIRCLE : vtkPlotPoints::DIAMOND);
            plot->SetMarkerSize(float(0.8 * font_ * FlatPicture::scale));
            plot->SetWidth(float(1.5 * FlatPicture::scale));
            chart_->AddPlot(plot);
        }
    }

    // From data to the picture's pixels.
    [[nodiscard]] Pixel pixel_of(double time, double error) const {
        const auto along = [](vtkAxis* axis, double value, int coordinate) {
            const double from = axis->GetPoint1()[coordinate], to = axis->GetPoint2()[coordinate];
            return from + (std::log10(value) - axis->GetMinimum()) /
                              (axis->GetMaximum() - axis->GetMinimum()) * (to - from);
        };
        return {along(chart_->GetAxis(vtkAxis::BOTTOM), time, 0) / FlatPicture::scale,
                size_.height - along(chart_->GetAxis(vtkAxis::LEFT), error, 1) / FlatPicture::scale};
    }
    [[nodiscard]] double left() const {
        return chart_->GetAxis(vtkAxis::LEFT)->GetPoint1()[0] / FlatPicture::scale;
    }
    [[nodiscard]] double right() const {
        return chart_->GetAxis(vtkAxis::BOTTOM)->GetPoint2()[0] / FlatPicture::scale;
    }

    void draw_floor() {
        const double y = pixel_of(1, file_.floor).y;
        canvas_.add(Stroke{{{left(), y}, {right(), y}}, quiet_ink, 1, true});
        canvas_.add(Text{{right() - font_ / 2, y + 0.8 * font_},
                         "the reference itself is not surer than this",
                         font_ * 0.9,
                         quiet_ink,
                         Font::sans,
                         Align::right});
    }

    void draw_labels() {
        const double top = pixel_of(1, std::pow(10, chart_->GetAxis(vtkAxis::LEFT)->GetMaximum())).y;
        const double bottom = pixel_of(1, std::pow(10, chart_->GetAxis(vtkAxis::LEFT)->GetMinimum())).y;
        std::vector<NamedMark> names;
        std::vector<Pixel> marks, front;
        for (const MeasuredPoint& p : file_.points) {
            marks.push_back(pixel_of(milliseconds(p), error(p)));
            names.push_back({marks.back(), short_name(p, file_.points.front()),
                             p.on_front ? Font::bold : Font::sans, font_});
        }
        for (const MeasuredPoint* p : front_points()) front.push_back(pixel_of(milliseconds(*p), error(*p)));
        const auto placed = place_names(names, marks, front, {left(), top, right() - left(), bottom - top});
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!placed[i]) continue;
            const Area& area = placed[i]->area;
            const Rgb colour = colour_of(file_.points[i].scalar);
            if (!placed[i]->lead.empty()) canvas_.add(Stroke{placed[i]->lead, colour, 1, false});
            canvas_.add(Text{{area.x + area.width / 2, area.y + area.height / 2},
                             names[i].name,
                             font_,
                             colour,
                             names[i].font,
                             Align::centre});
        }
    }

    void draw_texts() {
        const MeasuredPoint& own = file_.points.front();
        const std::string scene = std::filesystem::path(file_.scene).filename().string();
        canvas_.add(
            Text{{font_, font_ * 1.4}, "What accuracy costs: " + scene, font_ * 1.4, ink, Font::bold});
        canvas_.add(Text{{font_, font_ * 3},
                         elided(std::to_string(file_.width) + " × " + std::to_string(file_.height) +
                                    " pixels; the scene's own: " + own.name +
                                    "; line and bold names: the Pareto front",
                                Font::sans, font_, size_.width - 2 * font_),
                         font_,
                         quiet_ink});
        draw_legend();
        double y = size_.height - font_ * (0.5 + 1.5 * double(file_.sentences.size()));
        for (const std::string& sentence : file_.sentences) {
            canvas_.add(
                Text{{font_, y}, elided(sentence, Font::sans, font_, size_.width - 2 * font_), font_, ink});
            y += 1.5 * font_;
        }
    }

    void draw_legend() {
        double x = font_;
        const double y = font_ * 4.6;
        for (const char* scalar : series_scalars) {
            if (std::none_of(file_.points.begin(), file_.points.end(),
                             [&](const MeasuredPoint& p) { return p.scalar == scalar; }))
                continue;
            canvas_.add(FilledArea{{x, y - font_ * 0.4, font_ * 0.8, font_ * 0.8}, colour_of(scalar)});
            canvas_.add(Text{{x + 1.2 * font_, y}, scalar, font_, ink});
            x += text_width(scalar, Font::sans, font_) + 2.6 * font_;
        }
        canvas_.add(Text{{x, y}, "●  stable     ◆  textbook", font_, ink});
    }

    const AccuracyFile& file_;
    PictureSize size_;
    double font_;
    FlatPicture picture_;
    vtkNew<vtkChartXY> chart_;
    Canvas canvas_;
};

} // namespace

Raster draw_accuracy_chart(const AccuracyFile& file, const PictureSize& size) {
    return AccuracyChart(file, size).draw();
}

} // namespace rayscope::drawing
