#include "visualizer/drawing/growth_chart.hpp"

#include "visualizer/drawing/flat_picture.hpp"
#include "visualizer/drawing/labels.hpp"
#include "visualizer/drawing/log_axis.hpp"
#include "visualizer/drawing/text.hpp"

#include <vtkChartXY.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkTable.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace rayscope::drawing {
namespace {

// Colour and mark both tell a stage: nobody has to see colours.
struct Look {
    const char* stage;
    const char* rays; // that it is drawn for: the hardest ones it serves
    Rgb colour;
    int marker;
};
constexpr std::array<Look, 6> looks{{
    {"scan", "other", {0x66, 0x66, 0x66}, vtkPlotPoints::CROSS},
    {"extents", "other", {0xD5, 0x5E, 0x00}, vtkPlotPoints::PLUS},
    {"octree", "other", {0x00, 0x72, 0xB2}, vtkPlotPoints::CIRCLE},
    {"bvh", "other", {0x00, 0x9E, 0x73}, vtkPlotPoints::SQUARE},
    {"projective", "eye", {0xAA, 0x3C, 0x84}, vtkPlotPoints::DIAMOND},
    {"light", "shadow", {0x22, 0x22, 0x22}, vtkPlotPoints::DIAMOND},
}};

class GrowthChart {
public:
    GrowthChart(const std::vector<GrowthSeries>& series, const PictureSize& size)
        : size_(size), font_(std::max(12.0, size.height / 55.0)), picture_(size) {
        for (const Look& look : looks)
            for (const GrowthSeries& s : series)
                if (s.stage == look.stage && s.rays == look.rays) drawn_.emplace_back(&s, &look);
    }

    [[nodiscard]] Raster draw() {
        lay_out();
        for (const auto& [series, look] : drawn_) add_line(*series, *look);
        picture_.scene()->AddItem(chart_);
        picture_.render(); // now the axes know their pixels
        draw_labels();
        canvas_.add(Text{{font_, font_ * 1.4},
                         "What each stage buys: time against the number of objects",
                         font_ * 1.4,
                         ink,
                         Font::bold});
        canvas_.add(
            Text{{font_, font_ * 3.2},
                 elided("clouds of balls that cover the same area; k: the time grows like N^k; bvh, octree, "
                        "extents and scan: rays into random directions",
                        Font::sans, font_, size_.width - 2 * font_),
                 font_,
                 quiet_ink});
        return picture_.finish(std::move(canvas_));
    }

private:
    void lay_out() {
        double least_x = infinity<double>, most_x = 1, least_y = infinity<double>, most_y = 1;
        for (const auto& [series, look] : drawn_)
            for (const auto& [objects, time] : series->points) {
                least_x = std::min(least_x, objects);
                most_x = std::max(most_x, objects);
                least_y = std::min(least_y, time);
                most_y = std::max(most_y, time);
            }
        if (drawn_.empty()) least_x = least_y = 1;
        // To the right there is room for the names.
        LogAxis(least_x, most_x * std::pow(most_x / least_x, 0.25)).apply(chart_->GetAxis(vtkAxis::BOTTOM));
        LogAxis(least_y, most_y).apply(chart_->GetAxis(vtkAxis::LEFT));
        for (const int position : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
            vtkAxis* axis = chart_->GetAxis(position);
            const auto text = text_property(Font::sans, font_ * FlatPicture::scale, ink);
            for (vtkTextProperty* own : {axis->GetLabelProperties(), axis->GetTitleProperties()}) {
                own->ShallowCopy(text);
                own->SetJustificationToCentered();
                own->SetVerticalJustificationToTop();
            }
            axis->GetGridPen()->SetColor(hair.red, hair.green, hair.blue);
        }
        vtkAxis* left = chart_->GetAxis(vtkAxis::LEFT);
        left->GetLabelProperties()->SetJustificationToRight();
        left->GetLabelProperties()->SetVerticalJustificationToCentered();
        left->GetTitleProperties()->SetVerticalJustificationToBottom();
        left->GetTitleProperties()->SetOrientation(90);
        left->SetTitle("time per ray: nanoseconds, one thread");
        chart_->GetAxis(vtkAxis::BOTTOM)->SetTitle("number of objects");
        chart_->SetAutoSize(false);
        chart_->SetSize(vtkRectf(0, 0, float((size_.width - font_) * FlatPicture::scale),
                                 float((size_.height - 4.5 * font_) * FlatPicture::scale)));
    }

    void add_line(const GrowthSeries& series, const Look& look) {
        vtkNew<vtkTable> table;
        vtkNew<vtkDoubleArray> x, y;
        x->SetName("objects");
        y->SetName("time");
        for (const auto& [objects, time] : series.points) {
            x->InsertNextValue(std::log10(objects));
            y->InsertNextValue(std::log10(time));
        }
        table->AddColumn(x);
        table->AddColumn(y);
        vtkNew<vtkPlotLine> curve;
        curve->SetInputData(table, 0, 1);
        curve->SetColor(look.colour.red, look.colour.green, look.colour.blue, 255);
        curve->SetWidth(float(2 * FlatPicture::scale));
        curve->SetMarkerStyle(look.marker);
        curve->SetMarkerSize(float(0.7 * font_ * FlatPicture::scale));
        chart_->AddPlot(curve);
    }

    [[nodiscard]] Pixel pixel_of(double objects, double time) const {
        const auto along = [](vtkAxis* axis, double value, int coordinate) {
            const double from = axis->GetPoint1()[coordinate], to = axis->GetPoint2()[coordinate];
            return from + (std::log10(value) - axis->GetMinimum()) /
                              (axis->GetMaximum() - axis->GetMinimum()) * (to - from);
        };
        return {along(chart_->GetAxis(vtkAxis::BOTTOM), objects, 0) / FlatPicture::scale,
                size_.height - along(chart_->GetAxis(vtkAxis::LEFT), time, 1) / FlatPicture::scale};
    }

    // Each name at the right end of its line; where lines end close together, one below the other.
    void draw_labels() {
        std::vector<std::pair<Pixel, std::size_t>> ends;
        for (std::size_t i = 0; i < drawn_.size(); ++i) {
            const auto& [objects, time] = drawn_[i].first->points.back();
            ends.emplace_back(pixel_of(objects, time), i);
        }
        std::sort(ends.begin(), ends.end(),
                  [](const auto& a, const auto& b) { return a.first.y < b.first.y; });
        double free = 0;
        for (const auto& [at, i] : ends) {
            const auto& [series, look] = drawn_[i];
            std::string name = series->stage + " (" + series->rays + ")";
            if (std::isfinite(series->exponent)) {
                std::array<char, 32> k{};
                std::snprintf(k.data(), k.size(), "  k = %.2f", series->exponent);
                name += k.data();
            }
            const double y = std::max(at.y, free);
            canvas_.add(Text{{at.x + 0.9 * font_, y}, name, font_, look->colour, Font::bold});
            free = y + 1.3 * font_;
        }
    }

    PictureSize size_;
    double font_;
    std::vector<std::pair<const GrowthSeries*, const Look*>> drawn_;
    FlatPicture picture_;
    vtkNew<vtkChartXY> chart_;
    Canvas canvas_;
};

} // namespace

Raster draw_growth_chart(const std::vector<GrowthSeries>& series, const PictureSize& size) {
    return GrowthChart(series, size).draw();
}

} // namespace rayscope::drawing
