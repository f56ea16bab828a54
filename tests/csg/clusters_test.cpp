#include "core/csg/clusters.hpp"
#include "tests/csg/lists.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

struct Merged {
    List list;
    std::vector<Cluster<double>> clusters;
};

// Every crossing has the same error bound.
Merged merged(List list, double bound) {
    Merged result;
    const std::size_t size = merge_clusters(
        std::span(list), [&](const auto& a, const auto& b) { return b.t - a.t <= 2 * bound; },
        [&](const Cluster<double>& c) { result.clusters.push_back(c); });
    list.resize(size);
    result.list = list;
    return result;
}

List by_solids(const std::vector<double>& times, const std::vector<std::uint32_t>& solids) {
    List list = list_of(0, times);
    for (std::size_t i = 0; i < list.size(); ++i) list[i].surface.solid = solids[i];
    return list;
}

TEST(Clusters, crossings_apart_stay) {
    const List list = list_of(1, {1, 2, 3, 4});
    const Merged result = merged(list, 0.001);
    EXPECT_EQ(result.list, list);
    EXPECT_TRUE(result.clusters.empty());
}

TEST(Clusters, a_thin_piece_and_a_thin_gap_vanish_alike) {
    const double thin = 1e-10;
    EXPECT_EQ(times(merged(list_of(1, {1, 1 + thin, 3, 4}), thin).list),
              (std::vector<double>{3, 4})); // a piece
    EXPECT_EQ(times(merged(list_of(1, {1, 3, 3 + thin, 4}), thin).list),
              (std::vector<double>{1, 4})); // a gap
    EXPECT_EQ(times(merged(list_of(1, {1, 1 + thin}), thin).list), (std::vector<double>{}));
    EXPECT_EQ(times(merged(list_of(1, {-3, -3 + thin, 0, 1}), thin).list), (std::vector<double>{0, 1}));
}

TEST(Clusters, the_sum_of_both_bounds_decides) {
    const double gap = 0x1p-20;
    EXPECT_EQ(merged(list_of(1, {1, 1 + gap}), gap / 2).list.size(), 0U); // just within
    EXPECT_EQ(merged(list_of(1, {1, 1 + gap}), gap * 0.49).list.size(), 2U);
    EXPECT_EQ(merged(list_of(1, {1, 1 + gap}), 0).list.size(), 2U);
    EXPECT_EQ(merged(list_of(1, {-1 - gap, -1}), gap / 2).list.size(), 0U);
}

TEST(Clusters, an_odd_one_keeps_one_crossing_of_the_leftmost_operand_that_goes_its_way) {
    const double thin = 1e-10;
    const Merged in = merged(by_solids({1, 1 + thin, 1 + 2 * thin, 5}, {8, 2, 4, 9}), thin);
    ASSERT_EQ(in.list.size(), 2U);
    EXPECT_EQ(in.list[0].surface.solid, 4U); // 2 runs the other way
    EXPECT_TRUE(in.list[0].entering);
    ASSERT_EQ(in.clusters.size(), 1U);
    EXPECT_EQ(in.clusters[0].count, 3);
    EXPECT_TRUE(in.clusters[0].kept);
    EXPECT_EQ(in.clusters[0].first, 1);
    EXPECT_EQ(in.clusters[0].last, 1 + 2 * thin);
    const Merged first = merged(by_solids({1, 1 + thin, 1 + 2 * thin, 5}, {4, 2, 8, 9}), thin);
    EXPECT_EQ(first.list[0].surface.solid, 4U);
    EXPECT_EQ(first.list[0].t, 1);
    const Merged out = merged(
        by_solids({1, 5, 5 + thin, 5 + 2 * thin, 5 + 3 * thin, 5 + 4 * thin}, {9, 3, 1, 4, 0, 2}), thin);
    ASSERT_EQ(out.list.size(), 2U);
    EXPECT_EQ(out.list[1].surface.solid, 2U);
    EXPECT_FALSE(out.list[1].entering);
    EXPECT_EQ(out.clusters[0].count, 5);
}

TEST(Clusters, an_even_one_of_four_vanishes_and_what_follows_is_not_lost) {
    const double thin = 1e-10;
    const Merged result = merged(list_of(1, {1, 1 + thin, 1 + 2 * thin, 1 + 3 * thin, 3, 4}), thin);
    EXPECT_EQ(times(result.list), (std::vector<double>{3, 4}));
    ASSERT_EQ(result.clusters.size(), 1U);
    EXPECT_EQ(result.clusters[0].count, 4);
    EXPECT_FALSE(result.clusters[0].kept);
}

TEST(Clusters, unbounded_ends_never_join_one) {
    const List list = list_of(1, {-inf, 0, 1, inf});
    EXPECT_EQ(merged(list, 0.01).list, list);
    const List all = list_of(1, {-inf, inf});
    EXPECT_EQ(merged(all, 1e300).list, all);
}

} // namespace
} // namespace rayscope::test
