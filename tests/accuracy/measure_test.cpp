#include "core/accuracy/report.hpp"
#include "core/accuracy/verdict.hpp"
#include "tests/support/scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace rayscope::test {
namespace {

Reference two_pixels() {
    Reference reference;
    reference.width = 2;
    reference.height = 1;
    reference.samples = {{{0.5, 0.5, 0.5}, {}, {3, 10, 0, 0}}, {{1, 0, 0}, {}, {none, 0, 0, 0}}};
    return reference;
}

Image image_of(std::vector<float> rgb) {
    Image image(2, 1);
    image.rgb = std::move(rgb);
    return image;
}

TEST(ImageError, is_zero_for_the_reference_itself) {
    const ImageError e =
        image_error(image_of({0.5F, 0.5F, 0.5F, 1, 0, 0}), {{3, 10, 0, 0}, {none, 0, 0, 0}}, two_pixels());
    EXPECT_EQ(e.wrong_pixels, 0U);
    EXPECT_EQ(e.t_max, 0);
    EXPECT_EQ(e.relative_rmse, 0);
    EXPECT_EQ(e.delta_e_max, 0);
    EXPECT_FALSE(e.psnr);
    EXPECT_EQ(e.energy_lost, 0);
}

TEST(ImageError, each_number_is_what_it_says) {
    Map map;
    const ImageError e = image_error(image_of({0.5F, 0.5F, 0.25F, 0, 0, 0}),
                                     {{3, 10.5, 0.25, 0}, {1, 4, 0, 0}}, two_pixels(), &map);
    EXPECT_EQ(e.wrong_pixels, 1U); // an object where there is none
    EXPECT_DOUBLE_EQ(e.t_max, 0.75);
    EXPECT_DOUBLE_EQ(e.t_rms, 0.75); // of the right pixel alone
    EXPECT_DOUBLE_EQ(e.relative_rmse, std::sqrt((0.25 * 0.25 + 1) / (0.75 + 1)));
    EXPECT_DOUBLE_EQ(e.energy_lost, 1.25 / 2.5);
    ASSERT_EQ(map.values.size(), 2U);
    EXPECT_FLOAT_EQ(float(e.delta_e_max), std::max(map.values[0], map.values[1]));
    EXPECT_NEAR(e.delta_e_mean, (map.values[0] + map.values[1]) / 2, 1e-5);
    // sRGB bytes: 188 for 0.5, 137 for 0.25.
    EXPECT_NEAR(e.psnr.value(), 10 * std::log10(2 * 3 * 255.0 * 255 / (51.0 * 51 + 255.0 * 255)), 1e-12);
}

TEST(ImageError, what_is_not_finite_counts_as_black) {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const ImageError e =
        image_error(image_of({nan, 1, 1, 1, 0, 0}), {{3, 10, 0, 0}, {none, 0, 0, 0}}, two_pixels());
    EXPECT_DOUBLE_EQ(e.relative_rmse, std::sqrt(0.75 / 1.75));
}

Measured made(Configuration configuration, double seconds, double error) {
    Measured m;
    m.configuration = configuration;
    m.seconds = {seconds, seconds, seconds, 5};
    m.error.relative_rmse = error;
    return m;
}

TEST(Verdict, says_what_the_stable_formulas_and_depth_cost) {
    const Configuration own{{}, 8, 0.01};
    Configuration school = own, shallow = own;
    school.numbers = {ScalarType::float32, Method::textbook};
    shallow.max_depth = 5;
    std::vector<Measured> list{made(own, 1.3, 0.001), made(school, 1, 0.2), made(shallow, 1.04, 0.01)};
    list[1].error.wrong_pixels = 1214;
    list[0].error.psnr = 40.4;
    list[2].error.psnr = 40;
    EXPECT_THAT(
        verdict(list, two_pixels()),
        testing::ElementsAre(
            "double stable costs 1.30 times what float textbook does and removes all its 1214 wrong pixels.",
            "Depth 8 instead of 5 costs 1.25 times as much and wins 0.4 dB.",
            "double stable, depth 8, weight 0.01 comes nearest to the reference: a relative RMSE of 0.001."));
}

TEST(Verdict, the_cheapest_within_a_target_is_found) {
    const Configuration own{{}, 8, 0.01};
    Configuration other = own;
    other.max_depth = 3;
    const std::vector<Measured> list{made(own, 2, 0.001), made(other, 1, 0.01)};
    Reference reference = two_pixels();
    EXPECT_EQ(cheapest_within(list, reference, 0.1), &list[1]);
    EXPECT_EQ(cheapest_within(list, reference, 0.01), &list[1]);
    EXPECT_EQ(cheapest_within(list, reference, 0.009), &list[0]);
    EXPECT_EQ(cheapest_within(list, reference, 0.0001), nullptr);
    reference.relative_rmse_floor = 0.02; // nothing is ranked below it
    EXPECT_EQ(cheapest_within(list, reference, 0.01), nullptr);
}

TEST(Report, json_keeps_every_number) {
    AccuracyReport report{"scene.toml", two_pixels(), {made({{}, 8, 0.01}, 0.1, 1 / 3.0)}, {"It is so."}};
    report.list[0].map = "error.pfm";
    const auto json = nlohmann::json::parse(accuracy_json(report));
    EXPECT_EQ(json.at("format"), "rayscope-accuracy");
    EXPECT_EQ(json.at("image").at("width"), 2);
    const auto& c = json.at("configurations").at(0);
    EXPECT_EQ(c.at("errors").at("relative_rmse").get<double>(), 1 / 3.0);
    EXPECT_TRUE(c.at("errors").at("psnr").is_null());
    EXPECT_EQ(c.at("map"), "error.pfm");
    EXPECT_EQ(json.at("sentences").at(0), "It is so.");
}

TEST(Report, csv_has_a_line_of_as_many_fields_for_each) {
    const AccuracyReport report{
        "s", two_pixels(), {made({{}, 8, 0.01}, 0.1, 0.5), made({{}, 2, 0.01}, 0.1, 0.5)}, {}};
    std::istringstream lines(accuracy_csv(report));
    std::string line;
    int count = 0;
    for (; std::getline(lines, line); ++count)
        EXPECT_EQ(std::count(line.begin(), line.end(), ','), 16) << line;
    EXPECT_EQ(count, 3);
}

TEST(Measure, tells_the_front_and_hands_out_the_maps) {
    SceneBuilder b;
    b.generic(Sphere<double>{}, Mat4d{1}, b.clear(0.5, 0.4, 1.5), "ball");
    b.scene().background = {0.3, 0.4, 0.5};
    ReferenceOptions options;
    options.width = 8;
    options.height = 6;
    options.limits = {20, 1e-9, 1000};
    const Reference reference = make_reference(b.scene(), options);
    MeasureOptions measuring;
    std::vector<std::size_t> maps;
    measuring.on_map = [&](const Configuration&, const Map& map) {
        maps.push_back(map.values.size());
        return std::string("map");
    };
    const auto list =
        measure(b.scene(), configurations("depth=1/depth=12", {{}, 4, 1e-6}), reference, measuring);
    ASSERT_EQ(list.size(), 3U);
    EXPECT_EQ(maps, (std::vector<std::size_t>{48, 48, 48}));
    EXPECT_LT(list[2].error.relative_rmse, list[0].error.relative_rmse);
    EXPECT_LT(list[0].error.relative_rmse, list[1].error.relative_rmse);
    EXPECT_TRUE(list[2].on_front); // the best always is
    for (const Measured& m : list) {
        EXPECT_EQ(m.seconds.runs, 5);
        EXPECT_LE(m.seconds.min, m.seconds.median);
        EXPECT_LE(m.seconds.median, m.seconds.max);
        EXPECT_EQ(m.map, "map");
    }
}

} // namespace
} // namespace rayscope::test
