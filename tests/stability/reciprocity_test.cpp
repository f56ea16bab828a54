// Guards against light that can't go back the way it came: an index turned over, a normal on the wrong side, a medium
// lost on the way out.

#include "core/reflection/mirror.hpp"
#include "core/refraction/snell.hpp"
#include "tests/stability/property.hpp"
#include "tests/support/scenes.hpp"

namespace rayscope::test {
namespace {

struct Bend {
    Vec3d direction, normal;
    double from, to; // speeds
};

std::string line_of(const Bend& b) {
    return "{" + hex(b.direction) + ", " + hex(b.normal) + ", " + hex(b.from) + ", " + hex(b.to) + "},";
}

// Grazing, perpendicular, near the critical angle; media alike, and as different as a thousand to one.
Bend draw_bend(Random& random) {
    const Vec3d n = random.direction();
    const Vec3d across = normalized(cross(n, random.direction()));
    const double from = random.decade(-1.5, 1.5);
    const double to = random.below(4) == 0 ? from * (1 + random.decade(-15, -1)) : random.decade(-1.5, 1.5);
    double sine = random.coin() ? random.uniform(0, 1) : random.decade(-12, 0);
    if (random.below(3) == 0) sine = 1 - random.decade(-12, 0);
    if (random.below(3) == 0 && from < to)
        sine = from / to * (1 + (random.coin() ? 1 : -1) * random.decade(-15, -1));
    sine = std::min(sine, 1.0);
    return {normalized(sine * across - std::sqrt((1 - sine) * (1 + sine)) * n), n, from, to};
}

// The bent direction's part across the normal is off by a few ε, for its components are rounded in the world's axes; on
// the way back it is divided by η, and where the ray came grazing, the part along the normal, √(1 − sin²), moves by
// that times tan θ.
double way_back_bound(const Refraction<double>& bent) {
    const double across = 8 * epsilon<double> * std::max(1.0, 1 / bent.eta);
    return across * (1 + bent.sine / bent.cosine);
}

Verdict judge_bend(const Bend& b) {
    const Refraction<double> bent = refract<double>(b.direction, b.normal, b.from, b.to);
    if (bent.total()) {
        // Nothing gets through, however little the sine exceeds the critical one; the mirror's way back is the same way.
        if (!(b.from < b.to)) return {"total reflection on the way into a slower medium"};
        const Vec3d mirror = mirrored<double>(b.direction, b.normal);
        const Vec3d back = -mirrored<double>(-mirror, b.normal);
        const double off = length(back - b.direction);
        if (!(off <= 8 * epsilon<double>)) return {"mirrored there and back: off by " + hex(off)};
        return {};
    }
    if (!(std::abs(length(bent.direction) - 1) <=
          8 * epsilon<double> * std::max(1.0, 1 / std::sqrt(bent.radicand))))
        return {"not unit: " + hex(bent.direction)};
    const double bound = way_back_bound(bent);
    const Refraction<double> back = refract<double>(-bent.direction, b.normal, b.to, b.from);
    const bool grazing = bent.cosine * bent.cosine <= 4 * bound;
    if (back.total()) return {grazing ? "" : "the way back is totally reflected", !grazing};
    if (grazing) return {"", false};
    const double off = length(back.direction + b.direction);
    if (!(off <= bound)) return {"the way back is off by " + hex(off) + ", allowed " + hex(bound)};
    return {};
}

void expect_reciprocal_bends(int cases) {
    int decided = 0, asked = 0;
    expect_property("refract", std::max(1, cases / cases_of_a_seed), [&] {
        Random random(
            *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>())));
        for (int i = 0; i < cases_of_a_seed; ++i) {
            const Bend b = draw_bend(random);
            const Verdict verdict = judge_bend(b);
            ++asked;
            decided += verdict.decided ? 1 : 0;
            if (!verdict.wrong.empty()) RC_FAIL(verdict.wrong + '\n' + line_of(b));
        }
    });
    EXPECT_GE(decided, asked / 2);
}

TEST(Reciprocity, a_refracted_direction_comes_back) { expect_reciprocal_bends(samples(100000)); }
TEST(ReciprocityFull, a_refracted_direction_comes_back) { expect_reciprocal_bends(samples(10000000)); }

// Glass in water in glass, a drilled block, a ring: each transmits all, so there is one path and no choice.
Workbench glass() {
    SceneBuilder b;
    const auto water = b.clear(0, 1, 1.33), crown = b.clear(0, 1, 1.5), diamond = b.clear(0, 1, 2.4);
    b.generic(Sphere<double>{}, scaling(2), water, "pool", 0);
    b.generic(Sphere<double>{}, translation({0.5, 0.2, 0}) * scaling(0.7), crown, "ball", 1);
    b.generic(Torus<double>{0.4}, translation({-0.8, 0, 0.3}) * rotation({1, 0, 0}, 40), diamond, "ring", 2);
    b.operand("block", Cube<double>{}, translation({2, 1, -1}) * rotation(normalized(Vec3d{1, 2, 3}), 35));
    b.operand("bore", Cylinder<double>{}, translation({2, 1, -1}) * scaling(0.5, 0.5, 3));
    b.compound("drilled", "block - bore", crown, Mat4d{1}, 3);
    b.generic(Cone<double>{0.3}, translation({-2, -1.5, -0.5}) * shearing(0.4), crown, "stump", 1);
    b.scene().limits.max_depth = 24;
    return b.open();
}

// A path without branches: the places where it bends, and whether it got out.
struct Path {
    std::vector<Vec3d> places, directions; // a direction more: the first one
    std::vector<Id> objects;
    std::vector<bool> total;
    std::vector<double> errors; // of each place and of what it does to the direction
    bool out = false;
};

Path path_of(const Workbench& bench, const Ray<double>& ray) {
    const Trace trace = trace_ray(bench, ray);
    Path path;
    for (int id = 0;;) {
        const TracedRay& part = trace.rays[std::size_t(id)];
        path.directions.push_back(part.start().direction);
        const auto* hit = part.find<BoundaryChosen>();
        if (hit == nullptr) {
            path.out = part.find<Missed>() != nullptr;
            return path;
        }
        const double cosine = std::abs(dot(hit->facing, part.start().direction));
        double out_cosine = cosine;
        if (const auto* bent = part.find<Refracted>()) out_cosine = std::cos(bent->theta_to);
        path.places.push_back(hit->point);
        // Names of objects differ from trace to trace in number, not in text.
        const auto& drawn = bench.scene.drawn;
        for (std::size_t i = 0; i < drawn.size(); ++i)
            if (object_title(bench.scene, drawn[i]) == trace.objects[std::size_t(hit->object)].name)
                path.objects.push_back(Id(i));
        path.total.push_back(part.find<TotallyReflected>() != nullptr);
        // The sharpest of the bodies, the ring's tube, turns its normal by 2.5 a length.
        const double off = hit->error_bound + epsilon<double> * length(hit->point);
        path.errors.push_back(4 * (off + 8 * epsilon<double>) / std::min(cosine, out_cosine));
        if (part.children.empty()) return path;
        id = part.children.front();
    }
}

Ray<double> nudged(Ray<double> ray, int axis, double step) {
    (axis < 3 ? ray.origin[axis] : ray.direction[axis - 3]) += step;
    ray.direction = normalized(ray.direction);
    return ray;
}

// By how much more an error in the middle of a path is off at its end: measured by steps of 2⁻²⁶ in every direction;
// infinite where they go another way.
double growth(const Workbench& bench, const Ray<double>& ray) {
    constexpr double step = 0x1p-26;
    const Path path = path_of(bench, ray);
    double most = 1;
    for (int axis = 0; axis < 6; ++axis) {
        const Path other = path_of(bench, nudged(ray, axis, step));
        if (other.objects != path.objects || other.total != path.total) return infinity<double>;
        most = std::max(most, length(other.directions.back() - path.directions.back()) / step);
        if (!path.places.empty())
            most = std::max(most, length(other.places.back() - path.places.back()) / step);
    }
    return most;
}

// Every bend's own errors there and back, each grown on the rest of the way back.
double path_bound(const Workbench& bench, const Path& there, const Path& back, const Ray<double>& start) {
    double bound = growth(bench, start) * there.errors.back();
    for (std::size_t i = 0; i + 1 < back.places.size(); ++i) {
        const Vec3d middle = (back.places[i] + back.places[i + 1]) / 2.0;
        bound += growth(bench, {middle, back.directions[i + 1]}) *
                 (back.errors[i] + there.errors[there.errors.size() - 1 - i]);
    }
    return 6 * (bound + back.errors.back()); // six components, each by its own step
}

Verdict judge_path(const Workbench& bench, const Ray<double>& ray) {
    const Path there = path_of(bench, ray);
    if (!there.out || there.places.empty()) return {"", false};
    const Ray<double> start{there.places.back() + 3.0 * there.directions.back(), -there.directions.back()};
    Path back = path_of(bench, start);
    const double bound = path_bound(bench, there, back, start);
    if (!(bound < 0x1p-20)) return {"", false};
    std::reverse(back.objects.begin(), back.objects.end());
    std::reverse(back.total.begin(), back.total.end());
    if (!back.out || back.objects != there.objects || back.total != there.total)
        return {"goes back another way, of " + std::to_string(back.objects.size()) + " bends instead of " +
                std::to_string(there.objects.size())};
    const double turned = length(back.directions.back() + ray.direction),
                 moved = length(back.places.back() - there.places.front());
    if (turned > bound || moved > bound)
        return {"comes back " + hex(moved) + " beside, turned by " + hex(turned) + ", allowed " + hex(bound)};
    return {"", true};
}

void expect_reciprocal_paths(int cases) {
    const Workbench bench = glass();
    int decided = 0, asked = 0, total = 0;
    expect_property("paths", cases, [&] {
        Random random(
            *rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>())));
        const Vec3d from = 8.0 * random.direction();
        const Ray<double> ray{from, normalized(random.in_cube(2) - from)};
        const Verdict verdict = judge_path(bench, ray);
        ++asked;
        decided += verdict.decided ? 1 : 0;
        if (verdict.decided)
            for (const bool one : path_of(bench, ray).total) total += one ? 1 : 0;
        if (!verdict.wrong.empty()) RC_FAIL(verdict.wrong + '\n' + hex(ray));
    });
    EXPECT_GE(decided, asked / 2) << "of " << asked;
    EXPECT_GE(total, decided / 20);
}

TEST(Reciprocity, a_path_through_glass_goes_back_the_same_way) { expect_reciprocal_paths(samples(500)); }
TEST(ReciprocityFull, a_path_through_glass_goes_back_the_same_way) {
    expect_reciprocal_paths(samples(50000));
}

} // namespace
} // namespace rayscope::test
