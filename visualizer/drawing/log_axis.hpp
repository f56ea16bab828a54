#pragma once
// A logarithmic axis with readable ticks: VTK's own has none where the values span less than a decade.

#include <vtkAxis.h>

namespace rayscope::drawing {

/// Shows log10 of values; a tick at each power of ten, or at 1, 2, 5 where those are few.
class LogAxis {
public:
    /// @param least, most of the values; positive
    LogAxis(double least, double most);

    void apply(vtkAxis* axis) const;

private:
    double from_, to_; // decades
};

} // namespace rayscope::drawing
