#pragma once
// An image, shared out to threads tile by tile.

#include "core/tracer/render.hpp"

namespace rayscope {

/// A rectangle of pixels; the last row and column are not part of it.
struct Tile {
    int left, top, right, bottom;
};

/// Calls work(tile), by several threads at once, until every pixel was in one tile or options.stop is set.
/// @return false if it was stopped
[[nodiscard]] bool for_each_tile(int width, int height, const RenderOptions& options,
                                 const std::function<void(const Tile&)>& work);

/// Processor and wall time since it was made: seconds.
class Stopwatch {
public:
    Stopwatch();
    [[nodiscard]] double cpu_seconds() const;
    [[nodiscard]] double wall_seconds() const;

private:
    double cpu_start_, wall_start_;
};

} // namespace rayscope
