// Polygons become triangles that cover them, and nothing else.

#include "core/mesh/closed.hpp"
#include "core/mesh/triangulate.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/random.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace rayscope::test {
namespace {

Vec3d area(const std::vector<Vec3d>& p, const MeshData::Corners& t) {
    return cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
}

TEST(Triangulate, ell_is_not_covered_twice) {
    const std::vector<Vec3d> ell{{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
    Triangulation cut;
    double sum = 0;
    for (const auto& t : cut.of(ell)) {
        EXPECT_GT(area(ell, t).z, 0);
        sum += area(ell, t).z / 2;
    }
    EXPECT_DOUBLE_EQ(sum, 3);
}

// Corners that are given twice, and a spike that leads out and back, change nothing of what is covered.
TEST(Triangulate, doubled_corners_and_spikes_cover_nothing) {
    const std::vector<Vec3d> ell{{0, 0, 0}, {4, 0, 0}, {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
    Triangulation cut;
    const auto expect_ell = [&](const std::vector<Vec3d>& corners) {
        double sum = 0;
        for (const auto& t : cut.of(corners)) {
            EXPECT_GE(area(corners, t).z, 0);
            sum += area(corners, t).z / 2;
        }
        EXPECT_DOUBLE_EQ(sum, 6);
    };
    for (unsigned doubled = 0; doubled < 64; ++doubled) {
        std::vector<Vec3d> corners;
        for (unsigned i = 0; i < 6; ++i) corners.insert(corners.end(), (doubled >> i & 1U) + 1, ell[i]);
        expect_ell(corners);
    }
    std::vector<Vec3d> spiked = ell;
    spiked.insert(spiked.begin() + 2, {Vec3d{5, 0, 0}, Vec3d{4, 0, 0}});
    expect_ell(spiked);
}

// Stars with deep bays, turned any way: every triangle runs like the outline, and their areas add up to its own.
TEST(Triangulate, stars) {
    Random random(4);
    Triangulation cut;
    for (int i = 0; i < samples(300); ++i) {
        const Vec3d u = random.direction(), w = normalized(cross(u, random.direction())), v = cross(w, u);
        std::vector<Vec3d> star;
        const int corners = 4 + random.below(40);
        for (int k = 0; k < corners; ++k) {
            const double angle = 2 * std::numbers::pi * k / corners, r = random.uniform(0.1, 1);
            star.push_back(r * (std::cos(angle) * u + std::sin(angle) * v));
        }
        Vec3d whole{0}, sum{0};
        for (std::uint32_t k = 1; k + 1 < std::uint32_t(corners); ++k) whole += area(star, {0, k, k + 1});
        double sizes = 0;
        const auto triangles = cut.of(star);
        ASSERT_EQ(triangles.size(), std::size_t(corners - 2));
        for (const auto& t : triangles) {
            sum += area(star, t);
            sizes += length(area(star, t));
        }
        ASSERT_NEAR(length(whole - sum), 0, 1e-12);
        ASSERT_NEAR(sizes, length(whole), 1e-12);
    }
}

// Whatever the outline, its sides are sides of the triangles, and each cut is a side of two: no hole is made.
TEST(Triangulate, outlines_that_cross_themselves_stay_closed) {
    Random random(5);
    Triangulation cut;
    for (int i = 0; i < samples(300); ++i) {
        const auto corners = std::uint32_t(4 + random.below(12));
        MeshData data;
        for (std::uint32_t k = 0; k < corners; ++k) data.positions.push_back(random.in_cube(1));
        for (const auto& t : cut.of(data.positions)) data.triangles.push_back(t);
        data.positions.push_back({0, 0, 9});
        for (std::uint32_t k = 0; k < corners; ++k) data.triangles.push_back({(k + 1) % corners, k, corners});
        ASSERT_FALSE(find_hole(data));
    }
}

} // namespace
} // namespace rayscope::test
