// What is drawn is what was traced, bit for bit.

#include "visualizer/drawing/trace_geometry.hpp"

#include "tests/drawing/bowl.hpp"
#include "visualizer/drawing/clip_compound.hpp"
#include "visualizer/drawing/ray_path.hpp"

#include <gtest/gtest.h>
#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cstring>

namespace rayscope::test {
namespace {

using namespace rayscope::drawing;

bool same_bits(const Vec3d& a, const Vec3d& b) { return std::memcmp(&a, &b, sizeof a) == 0; }

double value(vtkDataSetAttributes* data, const char* array, vtkIdType row) {
    vtkDataArray* found = data->GetArray(array);
    EXPECT_NE(found, nullptr) << array;
    return found == nullptr ? 0 : found->GetTuple1(row);
}

TEST(TraceGeometry, a_ray_runs_from_its_origin_to_its_end) {
    const Trace trace = bowl_trace();
    ASSERT_GT(trace.rays.size(), 10U);
    const auto data = rays_polydata(trace, 3);
    ASSERT_EQ(data->GetNumberOfLines(), vtkIdType(trace.rays.size()));
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const TracedRay& ray = trace.rays[i];
        const RaySpawned& start = ray.start();
        const auto row = vtkIdType(i);
        EXPECT_TRUE(same_bits(point_of(data, 2 * row), start.origin)) << i;
        const Vec3d end = point_of(data, 2 * row + 1);
        if (const auto* hit = ray.find<BoundaryChosen>()) {
            EXPECT_TRUE(same_bits(end, hit->point)) << i;
            EXPECT_EQ(value(data->GetCellData(), "t_hit", row), hit->boundary.t);
        } else {
            EXPECT_TRUE(std::isnan(value(data->GetCellData(), "t_hit", row)));
            if (start.kind != RayKind::shadow) {
                EXPECT_NEAR(length(end - start.origin), 3, 1e-12) << "goes on without end";
            }
        }
        EXPECT_EQ(value(data->GetCellData(), "parent_id", row), ray.parent);
        EXPECT_EQ(value(data->GetCellData(), "depth", row), start.depth);
        EXPECT_EQ(value(data->GetCellData(), "weight", row), weight(ray));
    }
}

TEST(TraceGeometry, a_shadow_ray_ends_at_its_light_or_where_it_is_blocked) {
    const Trace trace = bowl_trace();
    std::size_t seen = 0;
    for (const TracedRay& ray : trace.rays) {
        if (ray.start().kind != RayKind::shadow) continue;
        const RayEnd end = drawn_end(ray, 3);
        EXPECT_FALSE(end.open);
        EXPECT_EQ(end.t < ray.start().reach, is_blocked(ray));
        EXPECT_LE(end.t, ray.start().reach);
        ++seen;
    }
    EXPECT_GT(seen, 0U);
}

TEST(TraceGeometry, hits_are_the_points_as_recorded) {
    const Trace trace = bowl_trace();
    const auto data = hits_polydata(trace);
    vtkIdType row = 0;
    for (std::size_t i = 0; i < trace.rays.size(); ++i) {
        const auto* hit = trace.rays[i].find<BoundaryChosen>();
        if (hit == nullptr) continue;
        ASSERT_LT(row, data->GetNumberOfPoints());
        EXPECT_TRUE(same_bits(point_of(data, row), hit->point)) << i;
        Vec3d normal;
        data->GetPointData()->GetNormals()->GetTuple(row, &normal.x);
        EXPECT_TRUE(same_bits(normal, hit->normal)) << i;
        EXPECT_EQ(value(data->GetPointData(), "ray_id", row), double(i));
        ++row;
    }
    EXPECT_EQ(row, data->GetNumberOfPoints());
}

TEST(TraceGeometry, inside_intervals_lie_on_their_rays_at_the_recorded_t) {
    const Trace trace = bowl_trace();
    const auto data = spans_polydata(trace, 3);
    vtkIdType row = 0;
    for (const TracedRay& ray : trace.rays)
        for (std::size_t e = 0; e < ray.events.size(); ++e) {
            if (!std::holds_alternative<NodeEvaluated>(ray.events[e])) continue;
            for (const SpanFound& span : spans_after(ray, e)) {
                if (!(span.exit.t > 0)) continue;
                ASSERT_LT(row, data->GetNumberOfLines());
                const Ray<double> line{ray.start().origin, ray.start().direction};
                EXPECT_TRUE(same_bits(point_of(data, 2 * row), line.at(std::max(span.enter.t, 0.0))));
                if (std::isfinite(span.exit.t)) {
                    EXPECT_TRUE(same_bits(point_of(data, 2 * row + 1), line.at(span.exit.t)));
                }
                EXPECT_EQ(value(data->GetCellData(), "t_enter", row), span.enter.t);
                EXPECT_EQ(value(data->GetCellData(), "t_exit", row), span.exit.t);
                ++row;
            }
        }
    EXPECT_EQ(row, data->GetNumberOfLines());
    EXPECT_GT(row, 10);
}

} // namespace
} // namespace rayscope::test
