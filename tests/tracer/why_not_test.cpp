#include "core/rayscope.hpp"
#include "core/scene/read_toml.hpp"

#include <gtest/gtest.h>

namespace {

using namespace rayscope;

TEST(WhyNot, NamesTheReasonAndWhere) {
    const Workbench bench = make_workbench(parse_toml("[camera]\neye = [0, 0, 5]\n[materials.m]\n"
                                                      "[generics.hit]\nshape = 'sphere'\nmaterial = 'm'\n"
                                                      "[generics.farther]\nshape = 'sphere'\nmaterial = 'm'\n"
                                                      "transform = [{translate = [0, 0, -4]}]\n"
                                                      "[generics.behind]\nshape = 'sphere'\nmaterial = 'm'\n"
                                                      "transform = [{translate = [0, 0, 9]}]\n"
                                                      "[generics.aside]\nshape = 'sphere'\nmaterial = 'm'\n"
                                                      "transform = [{translate = [5, 0, 0]}]\n",
                                                      "why_not.toml"));
    const Trace trace = trace_ray(bench, {{0, 0, 5}, {0, 0, -1}});
    const auto reason = [&](std::size_t object) { return why_not(bench, trace, 0, object); };
    EXPECT_EQ(reason(0).reason, WhyNot::Reason::accepted);
    EXPECT_EQ(reason(0).t, 4);
    EXPECT_EQ(reason(1).reason, WhyNot::Reason::farther);
    EXPECT_EQ(reason(1).t, 8);
    EXPECT_EQ(reason(2).reason, WhyNot::Reason::behind);
    EXPECT_EQ(reason(2).t, -3);
    EXPECT_EQ(reason(3).reason, WhyNot::Reason::line_misses);
}

TEST(WhyNot, AShadowRayEndsAtItsLight) {
    const Workbench bench = make_workbench(
        parse_toml("[camera]\neye = [0, 0, 5]\n[materials.m]\n[lights.l]\nposition = [0, 0, 4]\n"
                   "[generics.hit]\nshape = 'sphere'\nmaterial = 'm'\n"
                   "[generics.behind_the_light]\nshape = 'sphere'\nmaterial = 'm'\n"
                   "transform = [{scale = 0.1}, {translate = [0, 0, 4.5]}]\n",
                   "why_not.toml"));
    const Trace trace = trace_ray(bench, {{0, 0.5, 5}, {0, -0.125, -1}});
    ASSERT_EQ(trace.rays.size(), 2U);
    EXPECT_EQ(why_not(bench, trace, 1, 0).reason, WhyNot::Reason::behind);
    EXPECT_EQ(why_not(bench, trace, 1, 1).reason, WhyNot::Reason::beyond_reach);
}

} // namespace
