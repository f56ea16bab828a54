#include "core/trace/trace_json.hpp"
#include "tests/support/random_trace.hpp"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <rapidcheck.h>

namespace rayscope::test {
namespace {

using nlohmann::json;

/// The least that is a trace: one object of two nodes, one ray of three events.
Trace small_trace() {
    Trace trace;
    trace.source.scene = "bowl.toml";
    trace.generics = {"ball"};
    trace.objects = {
        {"bowl",
         "glass",
         {{Operation::leaf, none, none, 0, "ball"}, {Operation::complement, 0, none, none, "!ball"}}}};
    trace.media = {{"air", 1}};
    trace.lights = {{"key", false, {0, 0, 9}}};
    TracedRay ray;
    ray.events = {RaySpawned{}, NodeEvaluated{0, 1, 1}, SpanFound{{-infinity<double>}, {0.1, 0, 0, true}}};
    trace.rays = {ray};
    return trace;
}

/// The message that reading gives after one value is replaced.
std::string complaint(const char* pointer, const json& value) {
    json changed = to_json(small_trace());
    changed[json::json_pointer(pointer)] = value;
    try {
        (void)trace_from_json(changed);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no complaint";
}

std::string complaint_without(const char* parent, const char* member) {
    json changed = to_json(small_trace());
    changed[json::json_pointer(parent)].erase(member);
    try {
        (void)trace_from_json(changed);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "no complaint";
}

TEST(TraceJson, random_traces_survive_the_round_trip_through_text) {
    // JSON text is the comparison: it tells −0 from 0, and equal NaNs are equal.
    const bool held = rc::check("text → trace → text", [] {
        const std::string text = to_json(any_trace()).dump();
        RC_ASSERT(to_json(trace_from_json(json::parse(text))).dump() == text);
    });
    EXPECT_TRUE(held);
}

TEST(TraceJson, doubles_come_back_bit_for_bit) {
    const bool held = rc::check("double → text → double", [] {
        Trace trace = small_trace();
        trace.min_weight = any_double();
        const Trace back = trace_from_json(json::parse(to_json(trace).dump()));
        const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
        const bool same = std::isnan(trace.min_weight) ? std::isnan(back.min_weight)
                                                       : bits(trace.min_weight) == bits(back.min_weight);
        RC_ASSERT(same);
    });
    EXPECT_TRUE(held);
}

TEST(TraceJson, infinities_and_nan_are_words) {
    const json written = to_json(small_trace());
    EXPECT_EQ(written.at("/rays/0/events/2/enter/t"_json_pointer), "-inf");
    Trace trace = small_trace();
    trace.rays[0].events.emplace_back(Refracted{});
    EXPECT_EQ(to_json(trace).at("/rays/0/events/3/critical"_json_pointer), "nan");
    trace.min_weight = infinity<double>;
    EXPECT_EQ(to_json(trace).at("min_weight"), "inf");
}

TEST(TraceJson, every_member_is_needed) {
    const json whole = to_json(small_trace());
    for (const char* parent : {"", "/source", "/objects/0", "/objects/0/nodes/0", "/media/0", "/lights/0",
                               "/rays/0", "/rays/0/events/0", "/rays/0/events/1", "/rays/0/events/2/enter"})
        for (const auto& [member, value] : whole.at(json::json_pointer(parent)).items())
            EXPECT_NE(complaint_without(parent, member.c_str()), "no complaint") << parent << "/" << member;
}

TEST(TraceJson, messages_say_where_and_what) {
    EXPECT_EQ(complaint_without("/rays/0/events/1", "count"),
              "rays[0].events[1]: the member 'count' is missing");
    EXPECT_EQ(complaint("/rays/0/events/0/origin", nullptr),
              "rays[0].events[0].origin: expected a list of 3 numbers, found null");
    EXPECT_EQ(
        complaint("/rays/0/events/0/kind", "sideways"),
        "rays[0].events[0].kind: expected one of eye, reflected, refracted, shadow, found \"sideways\"");
    EXPECT_EQ(complaint("/rays/0/events/1/event", "dreamt"),
              "rays[0].events[1].event: expected the name of an event, found \"dreamt\"");
    EXPECT_EQ(complaint("/source/colour", 1), "source: unknown member 'colour'");
    EXPECT_EQ(complaint("/version", 2), "version: expected 4, found 2");
    EXPECT_EQ(complaint("/min_weight", "little"),
              "min_weight: expected a number, \"inf\", \"-inf\" or \"nan\", found \"little\"");
    EXPECT_EQ(complaint("/rays/0/events/1/object", 7),
              "rays[0].events[1].object: expected an index below 1, found 7");
    EXPECT_EQ(complaint("/rays/0/events/2/exit/leaf", -2),
              "rays[0].events[2].exit.leaf: expected an index below 1 or -1, found -2");
    EXPECT_EQ(complaint("/max_depth", 1e300),
              "max_depth: expected a whole number within range, found 1e+300");
    EXPECT_EQ(complaint("/max_depth", 4294967296),
              "max_depth: expected a whole number within range, found 4294967296");
    EXPECT_EQ(complaint("/events_dropped", -1),
              "events_dropped: expected a whole number within range, found -1");
}

TEST(TraceJson, what_is_no_tree_is_refused) {
    using testing::HasSubstr;
    EXPECT_THAT(complaint("/rays/0/parent", 0), HasSubstr("rays[0].parent: expected -1"));
    EXPECT_THAT(complaint("/rays/0/children", {0}), HasSubstr("rays[0].children"));
    EXPECT_THAT(complaint("/rays/0/children", {1}), HasSubstr("rays[0].children"));
    EXPECT_THAT(complaint("/rays", json::array()), HasSubstr("at least one ray"));
    EXPECT_THAT(complaint("/rays/0/events", json::array()), HasSubstr("begin with ray_spawned"));
    EXPECT_THAT(complaint("/objects/0/nodes/1/left", 1), HasSubstr("objects[0].nodes[1]"));
    EXPECT_THAT(complaint("/objects/0/nodes/0/generic", -1), HasSubstr("objects[0].nodes[0]"));
    EXPECT_THAT(complaint("/objects/0/nodes", json::array()), HasSubstr("at least one node"));
    EXPECT_THAT(complaint("/rays/0/events/1/node", 2), HasSubstr("expected an index below 2"));
    EXPECT_THAT(complaint("/rays/0/events/0/light", 0), HasSubstr("shadow rays ask for a light"));

    Trace two = small_trace();
    two.rays.push_back(two.rays[0]);
    two.rays[1].parent = 0; // but rays[0] does not name it
    EXPECT_THROW((void)trace_from_json(to_json(two)), std::runtime_error);
    two.rays[0].children = {1};
    EXPECT_NO_THROW((void)trace_from_json(to_json(two)));
    two.rays[1].parent = 1;
    EXPECT_THROW((void)trace_from_json(to_json(two)), std::runtime_error);
}

TEST(TraceJson, hostile_values_in_any_place_never_crash) {
    // Whatever stands where: it is read, or refused with a message; nothing else.
    const std::vector<json> hostile{nullptr,
                                    -1,
                                    2147483648,
                                    1e308,
                                    "",
                                    "nan",
                                    json::array(),
                                    json::object(),
                                    true,
                                    json::array({1, 2, 3}),
                                    json::array({json::object()})};
    const bool held = rc::check("one or two values replaced", [&] {
        json flat = to_json(any_trace()).flatten();
        std::vector<std::string> keys;
        for (const auto& [key, value] : flat.items()) keys.push_back(key);
        json changed = flat.unflatten();
        for (int n = any_below(2); n >= 0; --n) {
            const std::string key = *rc::gen::elementOf(keys);
            try {
                changed.at(json::json_pointer(key)) = *rc::gen::elementOf(hostile);
            } catch (const json::exception&) { // the first change took the second's place away
            }
        }
        try {
            (void)trace_from_json(changed);
        } catch (const std::runtime_error& error) {
            RC_ASSERT(std::string(error.what()).size() > 10U);
        }
    });
    EXPECT_TRUE(held);
    for (const json& value : hostile) EXPECT_THROW((void)trace_from_json(value), std::runtime_error);
}

} // namespace
} // namespace rayscope::test
