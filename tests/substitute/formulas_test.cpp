// Formulas of somebody else's in the tracer's place: right ones change nothing, wrong ones show where they are wrong.

#include "core/rayscope.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace rayscope::test {
namespace {

Workbench scene(const char* chapter_and_name) {
    return open(std::string(RAYSCOPE_SOURCE_DIR "/chapters/") + chapter_and_name + ".toml");
}

std::vector<std::pair<double, double>> unit_sphere(const Ray<double>& ray) {
    const double a = dot(ray.direction, ray.direction), middle = -dot(ray.origin, ray.direction) / a;
    const Vec3d nearest = ray.origin + middle * ray.direction;
    const double inside = 1 - dot(nearest, nearest);
    if (inside <= 0) return {};
    return {{middle - std::sqrt(inside / a), middle + std::sqrt(inside / a)}};
}

std::optional<Vec3d> bent(const Vec3d& d, const Vec3d& n, double c1, double c2) {
    const double eta = c2 / c1, cosine = dot(n, d), k = 1 - eta * eta * (1 - cosine * cosine);
    if (k < 0) return std::nullopt;
    return eta * d - (eta * cosine + std::sqrt(k)) * n;
}

Vec3d moved_normal(const Vec3d& n, const Mat4d& matrix) {
    return normalized(Vec3d(glm::transpose(glm::inverse(glm::dmat3(matrix))) * n));
}

std::vector<FormulaHit> without(const std::vector<FormulaHit>& a, const std::vector<FormulaHit>& b) {
    bool in_a = !a.empty() && !a.front().entering, in_b = !b.empty() && !b.front().entering;
    std::vector<FormulaHit> result;
    std::size_t i = 0, j = 0;
    while (i < a.size() || j < b.size()) {
        const bool from_a = i < a.size() && (j == b.size() || a[i].t <= b[j].t);
        FormulaHit hit = from_a ? a[i++] : b[j++];
        const bool before = in_a && !in_b;
        (from_a ? in_a : in_b) = hit.entering;
        if (before == (in_a && !in_b)) continue;
        hit.entering = !before;
        if (!from_a) hit.normal = -hit.normal;
        result.push_back(hit);
    }
    return result;
}

Ray<double> object_ray(const Ray<double>& ray, const Mat4d& matrix) {
    const glm::dmat4 inverse = glm::inverse(glm::dmat4(matrix));
    return {Vec3d(inverse * glm::dvec4(ray.origin, 1)), Vec3d(inverse * glm::dvec4(ray.direction, 0))};
}

FormulaWall at_wall(const Vec3d& d, const Vec3d& outward, double speed) {
    const double cosine = dot(d, outward);
    const bool enters = cosine < 0;
    FormulaWall wall{enters ? outward : -outward, enters ? 1 : speed, enters ? speed : 1, enters, false};
    const double eta = wall.speed_to / wall.speed_from;
    wall.total = 1 - eta * eta * (1 - cosine * cosine) < 0;
    return wall;
}

double mirrored_share(double c1, double c2, double cosine) {
    const double eta = c2 / c1, k = 1 - eta * eta * (1 - cosine * cosine);
    if (k < 0) return 1;
    const double across = (c2 * cosine - c1 * std::sqrt(k)) / (c2 * cosine + c1 * std::sqrt(k));
    const double along = (c1 * cosine - c2 * std::sqrt(k)) / (c1 * cosine + c2 * std::sqrt(k));
    return (across * across + along * along) / 2;
}

Formulas right() {
    Formulas formulas;
    formulas.mirror = [](const Vec3d&, const Vec3d& d, const Vec3d& n) { return d - 2 * dot(d, n) * n; };
    formulas.refract = bent;
    formulas.normal = moved_normal;
    formulas.sphere = unit_sphere;
    formulas.difference = without;
    formulas.to_object = object_ray;
    formulas.wall = at_wall;
    formulas.fresnel = mirrored_share;
    return formulas;
}

RenderOptions small() {
    RenderOptions options;
    options.width = 48;
    options.height = 36;
    return options;
}

/// Pixels whose bytes in a picture differ by more than 1.
int different_pixels(const Workbench& bench, const Formulas& formulas) {
    const Image ours = render(bench, small()).image, theirs = render(bench, formulas, small()).image;
    int count = 0;
    for (std::size_t i = 0; i < ours.rgb.size(); i += 3) {
        bool apart = false;
        for (std::size_t k = i; k < i + 3; ++k)
            apart = apart || std::abs(int(srgb_byte(ours.rgb[k])) - int(srgb_byte(theirs.rgb[k]))) > 1;
        count += apart ? 1 : 0;
    }
    return count;
}

std::optional<Difference> divergence(const Workbench& bench, const Formulas& formulas,
                                     const Ray<double>& ray) {
    const Precision precision = precision_of(ScalarType::float64);
    return compare(trace_ray(bench, ray), trace_ray(bench, formulas, ray), precision, precision).divergence;
}

class Substituted : public testing::TestWithParam<const char*> {};

TEST_P(Substituted, right_formulas_change_no_picture) {
    EXPECT_EQ(different_pixels(scene(GetParam()), right()), 0);
    EXPECT_EQ(different_pixels(scene(GetParam()), Formulas{}), 0);
}
INSTANTIATE_TEST_SUITE_P(Scenes, Substituted,
                         testing::Values("02_csg/glass_bowl", "02_csg/cylinder_with_holes",
                                         "03_reflection/mirror_room", "04_refraction/prism",
                                         "04_refraction/bubble", "07_accuracy/nested_glass",
                                         "08_effects/ice_water"));

const Ray<double> down_the_room{{-1.5, 0.25, 1.9}, {0.851801, -0.0798031, -0.517752}};

TEST(Formulas, a_wrong_mirror_parts_at_the_first_direction) {
    Formulas formulas;
    formulas.mirror = [](const Vec3d& p, const Vec3d&, const Vec3d& n) { return p - 2 * dot(p, n) * n; };
    const Workbench room = scene("03_reflection/mirror_room");
    EXPECT_GT(different_pixels(room, formulas), 300);
    const auto parted = divergence(room, formulas, down_the_room);
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->answer, Answer::direction);
    EXPECT_EQ(parted->ray, 0);
}

TEST(Formulas, a_mirror_is_told_where_the_ray_hits) {
    Formulas formulas = right();
    Vec3d asked{0};
    formulas.mirror = [&](const Vec3d& p, const Vec3d& d, const Vec3d& n) {
        if (asked == Vec3d{0}) asked = p;
        return d - 2 * dot(d, n) * n;
    };
    const Trace trace = trace_ray(scene("03_reflection/mirror_room"), formulas, down_the_room);
    EXPECT_EQ(asked, trace.rays.front().find<BoundaryChosen>()->point);
}

TEST(Formulas, a_difference_that_keeps_the_normal_shows_the_wrong_face) {
    Formulas formulas;
    formulas.difference = [](const auto& a, const auto& b) {
        auto hits = without(a, b);
        for (FormulaHit& hit : hits)
            for (const FormulaHit& from : b)
                if (from.source == hit.source) hit.normal = from.normal;
        return hits;
    };
    EXPECT_GT(different_pixels(scene("02_csg/glass_bowl"), formulas), 100);
}

TEST(Formulas, a_ray_made_unit_in_object_space_hits_at_another_t) {
    Formulas formulas;
    formulas.to_object = [](const Ray<double>& ray, const Mat4d& matrix) {
        const Ray<double> moved = object_ray(ray, matrix);
        return Ray<double>{moved.origin, normalized(moved.direction)};
    };
    const auto parted = divergence(scene("01_generics/ellipsoid"), formulas, {{3, 0.1, 6}, {0.2, 0, -1}});
    ASSERT_TRUE(parted);
    EXPECT_EQ(parted->answer, Answer::t);
}

TEST(Formulas, a_wall_that_is_lit_from_inside_parts_at_the_local_light) {
    Formulas formulas;
    formulas.wall = [](const Vec3d& d, const Vec3d& outward, double speed) {
        FormulaWall wall = at_wall(d, outward, speed);
        wall.local = true;
        return wall;
    };
    EXPECT_GT(different_pixels(scene("04_refraction/prism"), formulas), 20);
}

TEST(Formulas, a_wall_asks_of_objects_in_air_alone) {
    Formulas formulas;
    std::vector<double> asked;
    formulas.wall = [&](const Vec3d& d, const Vec3d& outward, double speed) {
        asked.push_back(speed);
        return at_wall(d, outward, speed);
    };
    (void)render(scene("08_effects/ice_water"), formulas, small());
    ASSERT_FALSE(asked.empty());
    for (const double speed : asked) EXPECT_LT(speed, 1);
}

TEST(Formulas, a_share_that_is_wrong_changes_the_light) {
    Formulas formulas;
    formulas.fresnel = [](double, double, double) { return 0.5; };
    EXPECT_GT(different_pixels(scene("08_effects/ice_water"), formulas), 100);
}

TEST(Formulas, that_throw_end_the_render) {
    Formulas formulas;
    formulas.sphere = [](const Ray<double>&) -> std::vector<std::pair<double, double>> {
        throw std::runtime_error("no answer");
    };
    const Workbench spheres = scene("02_csg/two_spheres");
    EXPECT_THROW((void)render(spheres, formulas, small()), std::runtime_error);
    EXPECT_EQ(different_pixels(spheres, Formulas{}), 0); // … and the next one is as it was
}

TEST(Formulas, that_return_nonsense_do_no_harm) {
    Formulas formulas;
    formulas.difference = [](const auto& a, const auto& b) {
        std::vector<FormulaHit> hits(a.rbegin(), a.rend());
        hits.insert(hits.end(), b.begin(), b.end());
        hits.push_back({std::nan(""), Vec3d{0}, true, 0});
        hits.push_back({1, Vec3d{0}, true, 1000000});
        hits.push_back({2, Vec3d{0}, true, -5});
        return hits;
    };
    formulas.mirror = [](const Vec3d&, const Vec3d&, const Vec3d&) { return Vec3d{std::nan("")}; };
    formulas.refract = [](const Vec3d&, const Vec3d&, double, double) { return Vec3d{0}; };
    formulas.normal = [](const Vec3d&, const Mat4d&) { return Vec3d{infinity<double>}; };
    formulas.wall = [](const Vec3d&, const Vec3d&, double) {
        return FormulaWall{Vec3d{0}, -1, infinity<double>, true, false};
    };
    formulas.fresnel = [](double, double, double) { return -1e300; };
    EXPECT_EQ(render(scene("02_csg/glass_bowl"), formulas, small()).image.width, 48);
    EXPECT_EQ(render(scene("08_effects/ice_water"), formulas, small()).image.width, 48);
    formulas.to_object = [](const Ray<double>&, const Mat4d&) {
        return Ray<double>{Vec3d{infinity<double>}, Vec3d{0}};
    };
    EXPECT_EQ(render(scene("02_csg/glass_bowl"), formulas, small()).image.width, 48);
}

} // namespace
} // namespace rayscope::test
