#include "tests/oracle/grid_checks.hpp"

#include "core/octree/octree.hpp"
#include "core/scene/build.hpp"
#include "tests/oracle/text.hpp"
#include "tests/support/hex.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>

namespace rayscope::test {
namespace {

using Fault = std::optional<std::string>;
using Index = std::array<int, 3>;

// An octree that is a grid: in each cell two balls that touch all its faces, so that one to a cell divides down to it and
// no extent is smaller than the cell.
class Grid {
public:
    explicit Grid(int depth)
        : cells_(1 << depth), world_(build(scene())), tree_(world_, {.depth = depth, .capacity = 1}) {}

    [[nodiscard]] std::vector<Index> visited(const Ray<double>& ray, double reach) const {
        Counters counters;
        std::vector<Index> list;
        tree_.walk(
            tree_.slabs(ray), counters, [&] { return reach; },
            [&](std::uint32_t /*leaf*/, const Cell& cell) {
                Index index;
                for (int axis = 0; axis < 3; ++axis)
                    index[std::size_t(axis)] = int(std::lround((cell.low[axis] + 1) / edge()));
                list.push_back(index);
                return false;
            });
        return list;
    }
    /// Whether a ray, as the tree sees it, meets the cell at some 0 ≤ t ≤ reach. The tree's planes are rounded.
    [[nodiscard]] bool touches(const Ray<double>& ray, const Index& index, double reach) const {
        Box<double> box;
        for (int axis = 0; axis < 3; ++axis) {
            box.low[axis] = -1 + edge() * index[std::size_t(axis)] - 64 * epsilon<double>;
            box.high[axis] = box.low[axis] + edge() + 128 * epsilon<double>;
        }
        return tree_.slabs(ray).may_hit(box, reach + 64 * epsilon<double> * (1 + std::abs(reach)));
    }

private:
    [[nodiscard]] double edge() const { return 2.0 / cells_; }
    [[nodiscard]] Scene scene() const {
        Scene scene;
        scene.materials.emplace_back();
        for (int i = 0; i < 2 * cells_ * cells_ * cells_; ++i) {
            const int cell = i / 2;
            SceneGeneric& ball = scene.generics.emplace_back();
            ball.shape = Sphere<double>{edge() / 2};
            ball.matrix[3] = {-1 + edge() * (0.5 + cell % cells_),
                              -1 + edge() * (0.5 + cell / cells_ % cells_),
                              -1 + edge() * (0.5 + cell / cells_ / cells_), 1};
            ball.material = 0;
            scene.drawn.push_back({false, std::size_t(i)});
        }
        return scene;
    }

    int cells_;
    World<double> world_;
    Octree<double> tree_;
};

std::string described(const std::vector<Index>& cells) {
    std::string list;
    for (const Index& c : cells) list += text(" (", c[0], ' ', c[1], ' ', c[2], ')');
    return list.empty() ? " none" : list;
}

Fault fault_in_walk(const Grid& grid, const GridCase& exact, const Ray<double>& ray, double reach) {
    const auto visited = grid.visited(ray, reach);
    auto next = visited.begin();
    for (const ExactSegment& segment : exact.segments) {
        const double rounding = 64 * epsilon<double> * (1 + std::abs(segment.to));
        if (segment.to - segment.from <= rounding || segment.from > reach) continue;
        next = std::find_if(next, visited.end(),
                            [&](const Index& c) { return std::ranges::count(segment.cells, c) > 0; });
        if (next == visited.end())
            return text("reach ", hex(reach),
                        ": in its order no cell of the segment from t = ", hex(segment.from),
                        ", which is one of", described(segment.cells), "; visited are", described(visited));
        ++next;
    }
    for (const Index& cell : visited)
        if (!grid.touches(ray, cell, reach))
            return text("reach ", hex(reach), ": visited without need:", described({cell}));
    return {};
}

// As it stands, and with zeros of the other sign, or so small that nothing else changes.
std::vector<Ray<double>> variants(const Ray<double>& ray) {
    std::vector<Ray<double>> list{ray};
    for (int axis = 0; axis < 3; ++axis)
        for (const double nothing : {0.0, -0.0, 0x1p-1074, -0x1p-1074}) {
            list.push_back(ray);
            if (ray.direction[axis] == 0) list.back().direction[axis] = nothing;
            if (ray.origin[axis] == 0) list.back().origin[axis] = nothing;
        }
    return list;
}

Fault grid_fault(const Grid& grid, const GridCase& exact) {
    for (const Ray<double>& ray : variants(exact.ray)) {
        std::vector<double> reaches{infinity<double>};
        for (const ExactSegment& segment : exact.segments) reaches.push_back((segment.from + segment.to) / 2);
        for (const double reach : reaches)
            if (auto fault = fault_in_walk(grid, exact, ray, reach))
                return text(*fault, "\n  ray ", hex(ray.origin), ", ", hex(ray.direction));
    }
    return {};
}

} // namespace

void expect_cells(const std::vector<GridCase>& cases) {
    constexpr int printed = 5;
    std::map<int, std::unique_ptr<Grid>> grids;
    int wrong = 0;
    for (const GridCase& exact : cases) {
        auto& grid = grids[exact.depth];
        if (!grid) grid = std::make_unique<Grid>(exact.depth);
        const Fault fault = grid_fault(*grid, exact);
        if (fault && wrong++ < printed) ADD_FAILURE() << *fault << "\n  in " << exact.id;
    }
    EXPECT_EQ(wrong, 0) << "cases wrong of " << cases.size();
}

} // namespace rayscope::test
