// Conditions on events: what they mean, and what is said where they mean nothing.

#include "core/rayscope.hpp"

#include <gmock/gmock.h>

namespace rayscope::test {
namespace {

using testing::HasSubstr;

class Expressions : public testing::Test {
protected:
    static const Workbench& prism() {
        static const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
        return bench;
    }
    static const Trace& trace() {
        const auto [x, y] = *prism().scene.step_pixel;
        static const Trace traced = trace_pixel(prism(), x, y);
        return traced;
    }
    static int count(const std::string& condition) {
        const auto found = first_occurrence(trace(), Expression(condition));
        return found ? found->count : 0;
    }
    template <typename E> static int events() {
        int count = 0;
        for (const TracedRay& ray : trace().rays)
            for (const Event& event : ray.events) count += std::holds_alternative<E>(event) ? 1 : 0;
        return count;
    }
    static std::string error(const std::string& text) {
        try {
            const Expression read(text, vocabulary_of(prism().scene));
            return "";
        } catch (const WrongExpression& failure) {
            return failure.what();
        }
    }
};

TEST_F(Expressions, words_count_the_events_that_they_name) {
    ASSERT_GT(events<TotallyReflected>(), 0);
    EXPECT_EQ(count("tir"), events<TotallyReflected>());
    EXPECT_EQ(count("totally_reflected"), events<TotallyReflected>());
    EXPECT_EQ(count("refraction"), events<Refracted>());
    EXPECT_EQ(count("hit"), events<BoundaryChosen>());
    EXPECT_EQ(count("enter") + count("exit"), count("hit"));
    EXPECT_EQ(count("spawn"), int(trace().rays.size()));
    EXPECT_EQ(count("event ray_finished"), int(trace().rays.size()));
    EXPECT_EQ(count("shadow-blocked || shadow-free || shadow-dimmed"), count("finish && kind shadow"));
}

TEST_F(Expressions, numbers_are_those_of_the_trace) {
    int deep = 0;
    for (const TracedRay& ray : trace().rays)
        if (ray.start().depth >= 2 && weight(ray) < 0.9) ++deep;
    EXPECT_EQ(count("spawn && depth >= 2 && weight < 0.9"), deep);
    EXPECT_EQ(count("hit && depth>=1 and not(depth>=1)"), 0);
    EXPECT_EQ(count("tir && theta_from > critical"), count("tir"));
    EXPECT_EQ(count("tir && theta_from - critical < 0"), 0);
    EXPECT_EQ(count("tir && abs(critical - theta_from) > 0 rad"), count("tir"));
    const auto* total =
        trace().rays[std::size_t(first_occurrence(trace(), Expression("tir"))->ray)].find<TotallyReflected>();
    const Expression angle("theta_from");
    EXPECT_TRUE(angle.angle());
    const auto at = *first_occurrence(trace(), Expression("tir"));
    EXPECT_DOUBLE_EQ(std::get<double>(angle.value({trace(), at.ray, at.event})),
                     total->theta_from * 180 / std::numbers::pi);
}

TEST_F(Expressions, components_and_owners) {
    const auto at = *first_occurrence(trace(), Expression("refraction"));
    const TracedRay& ray = trace().rays[std::size_t(at.ray)];
    const SeenEvent seen{trace(), at.ray, at.event};
    EXPECT_EQ(std::get<double>(Expression("direction.x").value(seen)), ray.start().direction.x);
    EXPECT_EQ(std::get<double>(Expression("refracted.direction.x").value(seen)),
              ray.find<Refracted>()->direction.x);
    EXPECT_EQ(std::get<double>(Expression("coefficient.g").value(seen)),
              ray.find<Refracted>()->coefficient.y);
    EXPECT_EQ(std::get<double>(Expression("-2 * (1 + 3) / 4").value(seen)), -2);
}

TEST_F(Expressions, what_an_event_does_not_have_is_neither_equal_nor_unequal) {
    EXPECT_EQ(count("miss && t > 0"), 0);
    EXPECT_EQ(count("miss && t != 0"), 0);
    EXPECT_EQ(count("miss && !(t == 0)"), events<Missed>());
}

TEST_F(Expressions, names_stand_beside_their_field) {
    const std::string object =
        trace().objects[std::size_t(trace().rays[0].find<BoundaryChosen>()->object)].name;
    EXPECT_GT(count("object " + object), 0);
    EXPECT_EQ(count("object " + object), count("object == '" + object + "'"));
    EXPECT_EQ(count("hit"), count("hit && object " + object) + count("hit && object != " + object));
    EXPECT_EQ(count("depth 0"), count("depth == 0"));
    EXPECT_EQ(count("hit ∧ depth ≤ 1"), count("hit && depth <= 1"));
}

TEST_F(Expressions, errors_name_the_column_and_what_was_expected) {
    EXPECT_EQ(error(""),
              "column 1: expected a condition, such as 'tir && depth >= 3', or a field, such as 'weight'");
    EXPECT_EQ(error("tri"), "column 1: no field or event is called 'tri'; did you mean 'tir'?");
    EXPECT_THAT(error("tir && depht > 2"),
                HasSubstr("column 8: no field or event is called 'depht'; did you mean 'depth'?"));
    EXPECT_THAT(error("tir &&"), HasSubstr("column 7: expected a field or a number, found the end"));
    EXPECT_THAT(error("tir & depth"), HasSubstr("column 5: '&' has no meaning here; 'and' is written &&"));
    EXPECT_THAT(error("(tir"), HasSubstr("column 5: expected ')', found the end"));
    EXPECT_THAT(error("tir)"), HasSubstr("column 4: expected an operator or the end, found ')'"));
    EXPECT_THAT(error("depth && tir"), HasSubstr("column 1: expected a condition, found a number"));
    EXPECT_THAT(error("object nothing_here"), HasSubstr("column 8: unknown name 'nothing_here'; expected "));
    EXPECT_THAT(error("kind mirrored"), HasSubstr("expected eye, reflected, refracted or shadow"));
    EXPECT_THAT(error("point > 3"),
                HasSubstr("column 1: expected a number, found a vector: take its .x, .y or .z"));
    EXPECT_THAT(error("1 < t < 2"), HasSubstr("column 7: comparisons can't follow each other"));
    EXPECT_THAT(error("weight.q"), HasSubstr("no field or event is called 'weight.q'"));
    EXPECT_THAT(error("depth.x"), HasSubstr("has no components"));
    EXPECT_THAT(error("missed.depth"), HasSubstr("the event missed has no field 'depth'"));
    EXPECT_THAT(error("object 'x"), HasSubstr("column 8: this quote is never closed"));
    EXPECT_THAT(error("divergence"), HasSubstr("choose it by diff first"));
    EXPECT_THAT(error("depth > 1e999"), HasSubstr("column 9: the number '1e999' is out of range"));
    EXPECT_THAT(error("θ > 3"), HasSubstr("column 1: 'θ' has no meaning here"));
    EXPECT_THAT(error("hit == 3"),
                HasSubstr("column 8: expected a condition to compare with, found a number"));
    EXPECT_THAT(error("object < b"), HasSubstr("a word is compared by == or !="));
}

TEST_F(Expressions, no_text_is_too_much) {
    EXPECT_THAT(error(std::string(100'000, '(')), HasSubstr("at most 4000 bytes"));
    EXPECT_THAT(error(std::string(3000, '(')), HasSubstr("within each other"));
    EXPECT_THAT(error(std::string(3000, '!')), HasSubstr("within each other"));
    EXPECT_THAT(error(std::string(3000, '-')), HasSubstr("within each other"));
    std::string chain = "tir";
    while (chain.size() < 3900) chain += "||tir";
    EXPECT_EQ(count(chain), count("tir"));
    for (const char* odd : {"\xff\xfe", "\"", "'", ".", "..", "a.", "1.2.3", "t-", "&&", "\0x", "abs", "abs(",
                            "inf inf", "ray.", "ray.ray", "object", "object ==", "object object", "not"})
        EXPECT_NO_THROW((void)error(odd)) << odd;
}

TEST(Find, counts_what_traces_of_single_pixels_count) {
    const Workbench bench = open(RAYSCOPE_SOURCE_DIR "/chapters/04_refraction/prism.toml");
    FindOptions options;
    options.render.width = 24;
    options.render.height = 18;
    for (const char* text : {"tir && depth >= 1", "hit && object prism", "node_evaluated && count > 0"}) {
        const Expression condition(text, vocabulary_of(bench.scene));
        const FindResult found = find(bench.scene, bench.world, condition, options);
        int pixels = 0;
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 24; ++x) {
                const auto one = first_occurrence(trace_pixel(bench, x, y, 24, 18), condition);
                ASSERT_EQ(int(found.events.at(x, y)), one ? one->count : 0)
                    << text << " at " << x << ',' << y;
                pixels += one ? 1 : 0;
            }
        EXPECT_EQ(found.pixels, pixels);
        EXPECT_GT(pixels, 0) << text;
        EXPECT_TRUE(found.complete);
    }
}

} // namespace
} // namespace rayscope::test
