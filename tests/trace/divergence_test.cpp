// Where two runs part: what counts as a divergence, what does not, and which is the first.

#include "core/trace/divergence.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

const Precision in_double = precision_of(ScalarType::float64), in_float = precision_of(ScalarType::float32);

// A ray along −z that enters a ball at t = 4, is lit by a lamp that nothing hides, and is mirrored into the void.
Trace simple() {
    Trace trace;
    trace.objects = {{"ball", "red", {{Operation::leaf, none, none, 0, "ball"}}},
                     {"wall", "red", {{Operation::leaf, none, none, 1, "wall"}}}};
    trace.generics = {"ball", "wall"};
    trace.media = {{"air", 1}, {"ball", 0.5}};
    trace.lights = {{"lamp", false, {0, 0, 9}}};
    RaySpawned eye;
    eye.origin = {0, 0, 5};
    eye.direction = {0, 0, -1};
    eye.reach = infinity<double>;
    eye.medium = 0;
    BoundaryChosen hit;
    hit.object = 0;
    hit.boundary = {4, 0, 0, false};
    hit.entering = true;
    hit.error_bound = 32 * epsilon<double>;
    hit.point = {0, 0, 1};
    hit.normal = hit.facing = {0, 0, 1};
    hit.medium_from = hit.medium_to = 0;
    LightLit lit;
    lit.light = 0;
    lit.to_light = {0, 0, 1};
    lit.cosine = 1;
    lit.mirror_cosine = 1;
    RaySpawned shadow = eye;
    shadow.kind = RayKind::shadow;
    shadow.light = 0;
    shadow.origin = hit.point;
    shadow.direction = {0, 0, 1};
    RaySpawned mirrored = eye;
    mirrored.kind = RayKind::reflected;
    mirrored.depth = 1;
    mirrored.origin = hit.point;
    mirrored.direction = {0, 0, 1};
    trace.rays = {{none,
                   {1, 2},
                   {eye, NodeEvaluated{0, 0, 1}, SpanFound{{4, 0}, {6, 0}}, ObjectAccepted{0, 4}, hit,
                    AmbientLit{}, lit, Reflected{Colour{0.5}, 0, {0, 0, 1}},
                    NotSpawned{RayKind::refracted, Reason::coefficient_zero, 0, Colour{0}}, RayFinished{}}},
                  {0, {}, {shadow, RayFinished{Colour{1}, Colour{1}, 2, 2}}},
                  {0, {}, {mirrored, Missed{}, RayFinished{}}}};
    return trace;
}

template <typename E> E& event(Trace& trace, int ray, std::size_t which = 0) {
    for (Event& e : trace.rays[std::size_t(ray)].events)
        if (E* found = std::get_if<E>(&e); found != nullptr && which-- == 0) return *found;
    throw std::logic_error("no such event");
}

template <typename Change> Comparison compared(const Change& change, Precision precision = in_double) {
    const Trace first = simple();
    Trace second = simple();
    change(second);
    return compare(first, second, in_double, precision);
}

void expect_divergence(const Comparison& comparison, Answer answer, int ray) {
    ASSERT_TRUE(comparison.divergence.has_value());
    EXPECT_EQ(int(comparison.divergence->answer), int(answer));
    EXPECT_EQ(comparison.divergence->ray, ray);
}

TEST(Divergence, WhatAStageSparedIsNotMissing) {
    const Trace scanned = simple();
    Trace searched = simple();
    auto& events = searched.rays[0].events;
    events[1] = SearchBegan{StageKind::octree, 2}; // instead of the node and its span
    events[2] = SearchEnded{};
    EXPECT_FALSE(compare(scanned, searched, in_double, in_double).divergence);
    events[1] = events[2] = AmbientLit{};
    EXPECT_EQ(compare(scanned, searched, in_double, in_double).divergence->answer, Answer::spans);
}

TEST(Divergence, WhatTheSceneGivesIsAnAnswer) {
    const auto difference = [](const auto& edit) {
        Trace edited = simple();
        edit(edited);
        return compare(simple(), edited, in_double, in_double).divergence;
    };
    const auto light = difference([](Trace& trace) { event<LightLit>(trace, 0).intensity = Colour{0.5}; });
    ASSERT_TRUE(light);
    EXPECT_EQ(light->answer, Answer::given);
    EXPECT_EQ(light->what, "the intensity");
    EXPECT_EQ(light->light, 0);
    EXPECT_EQ(difference([](Trace& trace) { event<Missed>(trace, 2).background = Colour{1}; })->ray, 2);
    EXPECT_EQ(difference([](Trace& trace) { event<AmbientLit>(trace, 0).material = Colour{1}; })->what,
              "the material's ambient coefficient");
    EXPECT_EQ(difference([](Trace& trace) { event<Reflected>(trace, 0).coefficient = Colour{0.1}; })->what,
              "the coefficient of the reflected ray");
}

// Fresnel's shares, absorption and what follows from them are calculated: other numbers give other last digits.
TEST(Divergence, CalculatedSharesMayDifferByWhatPrecisionExplains) {
    Trace first = simple();
    event<Reflected>(first, 0).coefficient = Colour{0.25};
    first.rays[0].events.push_back(FresnelShared{0.3, 0.2, 0.24, 0.25, 0});
    event<RaySpawned>(first, 2).weight = Colour{0.25};
    const auto with_share = [&](double share) {
        Trace other = first;
        event<Reflected>(other, 0).coefficient = Colour{share};
        event<RaySpawned>(other, 2).weight = Colour{share};
        return compare(first, other, in_double, in_float).divergence;
    };
    EXPECT_FALSE(with_share(0.25 * (1 + 2e-7)));
    const auto wrong = with_share(0.26);
    ASSERT_TRUE(wrong);
    EXPECT_EQ(wrong->answer, Answer::share);
    EXPECT_EQ(wrong->next, RayKind::reflected);
}

TEST(Divergence, EqualTracesHaveNone) {
    const Comparison comparison = compared([](Trace&) {});
    EXPECT_FALSE(comparison.divergence);
    EXPECT_TRUE(comparison.complete);
    EXPECT_EQ(comparison.rays, 3);
    ASSERT_TRUE(comparison.largest);
    EXPECT_EQ(comparison.largest->ulps, 0);
}

TEST(Divergence, NamesAreComparedNotIndices) {
    const Comparison comparison = compared([](Trace& t) {
        std::swap(t.objects[0], t.objects[1]);
        std::swap(t.generics[0], t.generics[1]);
        event<NodeEvaluated>(t, 0).object = event<BoundaryChosen>(t, 0).object = 1;
        event<BoundaryChosen>(t, 0).boundary.leaf = 1;
    });
    EXPECT_FALSE(comparison.divergence);
}

TEST(Divergence, AnyOtherAnswerIsOne) {
    using Change = void (*)(Trace&);
    const std::vector<std::tuple<Answer, int, Change>> changes{
        {Answer::spans, 0, [](Trace& t) { event<NodeEvaluated>(t, 0).count = 2; }},
        {Answer::hit, 2, [](Trace& t) { t.rays[2].events[1] = event<BoundaryChosen>(t, 0); }},
        {Answer::object, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).object = 1; }},
        {Answer::face, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).boundary.face = 1; }},
        {Answer::side, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).entering = false; }},
        {Answer::media, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).medium_to = 1; }},
        {Answer::media, 2, [](Trace& t) { event<RaySpawned>(t, 2).medium = 1; }},
        {Answer::local_light, 0, [](Trace& t) { t.rays[0].events[5] = LocalLightSkipped{}; }},
        {Answer::shadow_ray, 0, [](Trace& t) { t.rays[0].children.erase(t.rays[0].children.begin()); }},
        {Answer::visibility, 1, [](Trace& t) { event<RayFinished>(t, 1).colour = Colour{0}; }},
        {Answer::total, 0, [](Trace& t) { t.rays[0].events.push_back(TotallyReflected{}); }},
        {Answer::followed, 0,
         [](Trace& t) { t.rays[0].events[7] = NotSpawned{RayKind::reflected, Reason::depth, 0, Colour{0}}; }},
        {Answer::followed, 0, [](Trace& t) { event<NotSpawned>(t, 0).reason = Reason::weight; }},
        {Answer::weight, 2, [](Trace& t) { event<RaySpawned>(t, 2).weight = Colour{0.25}; }},
        {Answer::origin, 0, [](Trace& t) { event<RaySpawned>(t, 0).origin.x = 1; }},
        {Answer::direction, 1, [](Trace& t) { event<RaySpawned>(t, 1).direction = {0.1, 0, 0.99}; }},
        {Answer::direction, 0, [](Trace& t) { event<RaySpawned>(t, 2).direction = {0.1, 0, 0.99}; }},
        {Answer::t, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).boundary.t = 4.01; }},
        {Answer::t, 0, [](Trace& t) { event<BoundaryChosen>(t, 0).boundary.t = not_a_number; }},
        {Answer::cosine, 0, [](Trace& t) { event<LightLit>(t, 0).cosine = 0.9; }},
        {Answer::mirror_cosine, 0, [](Trace& t) { event<LightLit>(t, 0).mirror_cosine = 0.9; }},
    };
    for (const auto& [answer, ray, change] : changes) {
        SCOPED_TRACE("answer " + std::to_string(int(answer)));
        expect_divergence(compared(change), answer, ray);
    }
}

TEST(Divergence, TheFirstCounts) {
    expect_divergence(compared([](Trace& t) {
                          event<RaySpawned>(t, 2).weight = Colour{0.25};
                          event<RayFinished>(t, 1).colour = Colour{0};
                          event<LightLit>(t, 0).cosine = 0.9;
                      }),
                      Answer::visibility, 1);
}

TEST(Divergence, ANumberMayDifferByTheBoundsOfBothRuns) {
    const auto moved = [](double ulps) {
        return
            [ulps](Trace& t) { event<BoundaryChosen>(t, 0).boundary.t = 4 * (1 + ulps * epsilon<double>); };
    };
    const Comparison within = compared(moved(16)); // 4 · 16 ε = 32 ε + 32 ε
    EXPECT_FALSE(within.divergence);
    ASSERT_TRUE(within.largest);
    EXPECT_EQ(int(within.largest->answer), int(Answer::t));
    EXPECT_EQ(within.largest->ulps, 16);
    EXPECT_EQ(within.largest->size / within.largest->bounds, 1);
    const Comparison beyond = compared(moved(17));
    expect_divergence(beyond, Answer::t, 0);
    EXPECT_EQ(beyond.divergence->ulps, 17);
    EXPECT_EQ(beyond.divergence->first.x, 4);
}

TEST(Divergence, ARunWithoutBoundsIsGrantedTheOthersInItsOwnEpsilon) {
    const auto moved = [](double ulps) {
        return [ulps](Trace& t) {
            auto& hit = event<BoundaryChosen>(t, 0);
            hit.error_bound = 0;
            hit.boundary.t = 4 * (1 + ulps * in_float.epsilon);
        };
    };
    const Comparison within = compared(moved(7), in_float); // 28 ε of 32 ε
    EXPECT_FALSE(within.divergence);
    EXPECT_EQ(within.largest->ulps, 7);
    expect_divergence(compared(moved(9), in_float), Answer::t, 0);
}

TEST(Divergence, AStepIsNotBlamedForWhatItBeganWith) {
    // In float the ray starts 1e-7 lower, and meets a surface that slopes: t may differ by as much more.
    const auto lower = [](double t) {
        return [t](Trace& trace) {
            event<RaySpawned>(trace, 0).origin.z = 5 - 2e-7;
            event<BoundaryChosen>(trace, 0).error_bound = epsilon<double>;
            event<BoundaryChosen>(trace, 0).boundary.t = t;
        };
    };
    EXPECT_FALSE(compared(lower(4 - 2e-7), in_float).divergence);
    EXPECT_FALSE(compared(lower(4), in_float).divergence);
    expect_divergence(compared(lower(4 - 5e-7), in_float), Answer::t, 0);
}

TEST(Divergence, VisitsAreNoAnswers) {
    EXPECT_FALSE(compared([](Trace& t) {
                     event<RayFinished>(t, 0).tested = 99;
                     event<RaySpawned>(t, 2).left_object = 0;
                     event<RaySpawned>(t, 2).left_bound = 1;
                     t.rays[0].events.insert(t.rays[0].events.begin() + 4, ClusterMerged{0, 2, 4, 4, false});
                 }).divergence);
}

TEST(Divergence, WhatAShadowRayDidNotAskIsNotKnown) {
    Trace first = simple(), second = simple();
    for (Trace* trace : {&first, &second}) event<RayFinished>(*trace, 1).colour = Colour{0};
    first.rays[1].events.insert(first.rays[1].events.begin() + 1, NodeEvaluated{1, 0, 1});
    EXPECT_FALSE(compare(first, second, in_double, in_double).divergence);
    EXPECT_FALSE(compare(second, first, in_double, in_double).divergence);
    // A ray that went on has asked everything.
    event<RayFinished>(first, 1).colour = event<RayFinished>(second, 1).colour = Colour{1};
    expect_divergence(compare(first, second, in_double, in_double), Answer::spans, 1);
}

TEST(Divergence, BeyondAFullRecordNothingIsKnown) {
    const Comparison comparison = compared([](Trace& t) {
        t.rays[2].events = {t.rays[2].events.front(), Missed{Colour{1}}, Truncated{10}, RayFinished{}};
    });
    EXPECT_FALSE(comparison.divergence);
    EXPECT_FALSE(comparison.complete);
    const Comparison missing = compared([](Trace& t) {
        t.rays.resize(2);
        t.rays[0].children = {1};
    });
    EXPECT_FALSE(missing.divergence);
    EXPECT_FALSE(missing.complete);
}

TEST(Divergence, UlpsAreThoseOfTheNarrowerType) {
    const auto tilted = [](Trace& t) { event<BoundaryChosen>(t, 0).normal.z = 1 + in_float.epsilon; };
    EXPECT_EQ(compared(tilted, in_float).largest->ulps, 1);
    EXPECT_EQ(compared(tilted, in_double).largest->ulps, std::ldexp(1.0, 29));
    EXPECT_EQ(int(compared(tilted, in_double).largest->answer), int(Answer::normal));
}

} // namespace
} // namespace rayscope::test
