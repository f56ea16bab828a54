#pragma once
// The rays, hits, normals and lanes of a trace as strokes in view space.

#include "visualizer/drawing/lanes.hpp"
#include "visualizer/drawing/mesh.hpp"
#include "visualizer/drawing/view.hpp"

#include <vtkPolyData.h>

namespace rayscope::drawing {

/// How a ray is drawn.
enum class Emphasis : std::uint8_t { ghost, plain, path };

struct RayStyle {
    int ray = 0;
    Emphasis emphasis = Emphasis::plain;
};

/// Where strokes run in the picture, for labels to keep off.
struct FlatSegment {
    Pixel from, to;
};

/// A trace of more rays is drawn without the lightest ones.
inline constexpr std::size_t most_rays = 2500;

/// Rays in the order of drawing. Without a chosen ray all are plain; else its path stands out, what it spawned is
/// plain, and the rest are ghosts.
[[nodiscard]] std::vector<RayStyle> ray_styles(const Trace& trace, std::optional<int> chosen);

class RayStrokes {
public:
    /// @param pixels width of a hair line: 1 in a picture of the usual size
    RayStrokes(const View& view, const Region& region, double pixels)
        : view_(view), region_(region), pixels_(pixels) {}

    /// @param rays, hits see trace_geometry: the only source of points
    void draw(const Trace& trace, const std::vector<RayStyle>& styles, vtkPolyData* rays, vtkPolyData* hits);
    /// Beside the current ray: the lanes of its inside intervals.
    void draw_lanes(const Trace& trace, int ray, const Lanes& lanes, vtkPolyData* spans);

    /// The boxes that a stage looked into for one ray.
    void draw_places(int ray, vtkPolyData* places);

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }
    [[nodiscard]] const std::vector<FlatSegment>& segments() const { return segments_; }

private:
    void draw_ray(const TracedRay& ray, const Vec3d& first, const Vec3d& last, bool open, Emphasis emphasis);
    void tube(const Vec3d& from, const Vec3d& to, double width, Rgb colour);
    void dashes(const Vec3d& from, const Vec3d& to, double width, Rgb colour);
    void solid_arrow(const Vec3d& at, const Vec3d& direction, double size, Rgb colour);
    void open_arrow(const Vec3d& tip, const Vec3d& direction, double width, Rgb colour);
    void draw_hit(const Vec3d& point, const Vec3d& normal, bool with_normal, Emphasis emphasis);

    const View& view_;
    const Region& region_;
    double pixels_;
    double dash_ = 1; ///< length of a dash: 1 where rays are few
    Mesh mesh_;
    std::vector<FlatSegment> segments_;
};

} // namespace rayscope::drawing
