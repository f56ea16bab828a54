#include "visualizer/drawing/log_axis.hpp"

#include "visualizer/drawing/text.hpp"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <cmath>

namespace rayscope::drawing {
namespace {

constexpr double least_span = 0.6;     // decades, so that equal values stand in the middle
constexpr double edge_room = 0.07;     // of the span
constexpr double few = 2.5, many = 12; // decades

} // namespace

LogAxis::LogAxis(double least, double most) : from_(std::log10(least)), to_(std::log10(most)) {
    const double missing = std::max(0.0, least_span - (to_ - from_));
    const double span = to_ - from_ + missing;
    from_ -= missing / 2 + edge_room * span;
    to_ += missing / 2 + edge_room * span;
}

void LogAxis::apply(vtkAxis* axis) const {
    vtkNew<vtkDoubleArray> positions;
    vtkNew<vtkStringArray> labels;
    const int step = to_ - from_ > many ? int((to_ - from_) / many) + 1 : 1;
    for (int decade = int(std::floor(from_)); decade <= int(std::ceil(to_)); decade += step)
        for (const int digit : {1, 2, 5}) {
            if (digit > 1 && to_ - from_ > few) break;
            const double value = digit * std::pow(10.0, decade);
            if (std::log10(value) < from_ || std::log10(value) > to_) continue;
            positions->InsertNextValue(std::log10(value));
            labels->InsertNextValue(number(value));
        }
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(from_, to_);
    axis->SetCustomTickPositions(positions, labels);
}

} // namespace rayscope::drawing
