// Guards against acne and skipped gaps: a ray that leaves a surface meets it again, or misses what stands close to it.

#include "core/extents/scan.hpp"
#include "core/scene/build.hpp"
#include "core/tracer/interaction.hpp"
#include "tests/stability/draw_case.hpp"
#include "tests/stability/exact_line.hpp"
#include "tests/stability/property.hpp"
#include "tests/support/scenes.hpp"

namespace rayscope::test {
namespace {

// A place where the ray must, or may, be reported to end.
struct Expected {
    double t, bound;
    std::uint32_t object;
    bool certain; // no rounding within the bounds can take it away
};

// On the face that it leaves, the kernel takes the start for a point of the surface, which it is only within the
// distance that the ray carries. Where a quadric's one root moves by that, its other one, of the product or the sum of
// both, moves as far: the start's bound is added to its own.
double bound_of(const Solid<double>& solid, const Ray<double>& ray, const LeavingSurface<double>& start,
                double t, int face) {
    if (face != int(start.surface.face)) return solid.error_bound(ray, t, face);
    return solid.error_bound(ray, t, face, start.bound) + solid.error_bound(ray, 0, face, start.bound);
}

// Does the ray keep as close to the surface, from its start to t, as so many times what it may have started beside it?
bool hugs(const Solid<double>& solid, const Ray<double>& ray, const LeavingSurface<double>& start, double t,
          double times) {
    const Ray<double> moved = solid.transform.to_object(ray);
    const Vec3d n =
        std::visit([&](const auto& s) { return s.normal(moved.origin, start.surface.face); }, solid.shape);
    const double scale = length(n);
    const double off =
        start.bound * std::abs(dot(n, solid.transform.vector_to_object(solid.transform.normal_to_world(n))));
    const double limit = times * (off + solid.surface_distance(solid.point_error(ray, t), n)) / scale;
    constexpr int places = 8;
    for (int i = 1; i <= places; ++i)
        if (std::abs(implicit_value(solid.shape, moved.at(t * i / places))) > limit) return false;
    return true;
}

// A crossing of the start's direction up to which the ray hugs the surface this closely is the start, moved along a
// graze. The core asks in one place whether that is at most twice as far …
constexpr double surely_start = 2;
// … so that what is asked in more places may be twice that again: the crossing may be the start or another one, and one
// of the other direction may be rounding's.
constexpr double perhaps_start = 2 * surely_start;

// The crossings of the solid beyond the ray's start, which is one of its own. Two that lie within their bounds of each
// other may be seen or not.
std::vector<Expected> beyond_start(const Case& c, const Solid<double>& solid, const Ray<double>& ray,
                                   const LeavingSurface<double>& start, bool inward) {
    std::vector<Expected> found;
    for (const ExactCrossing& e : exact_crossings(c.shape, exact_object_ray(c.matrix, ray))) {
        const double t = double(e.t), bound = bound_of(solid, ray, start, t, e.face);
        const bool at_start = std::abs(t) <= 2 * bound || hugs(solid, ray, start, t, surely_start);
        if (at_start ? e.entering == inward : t < 0) continue;
        found.push_back({t, bound, 0, !at_start && !hugs(solid, ray, start, t, perhaps_start)});
    }
    for (std::size_t i = 0; i + 1 < found.size(); ++i)
        if (found[i + 1].t - found[i].t <= found[i].bound + found[i + 1].bound)
            found[i].certain = found[i + 1].certain = false;
    return found;
}

// The wall's own crossing: nothing of the solid makes it uncertain.
Expected at_wall(const World<double>& world, const Mat4d& matrix, const Ray<double>& ray) {
    const auto crossings = exact_crossings(Plane<double>{}, exact_object_ray(matrix, ray));
    if (crossings.empty()) return {infinity<double>, 0, 1, false};
    const double t = double(crossings[0].t), bound = world.solids[1].error_bound(ray, t, 0);
    return {t, bound, 1, t > 4 * bound};
}

/// What was reported, and whether rounding alone may have put it there: a piece or a gap of the solid that is as thin as
/// the bounds of its two ends, the start being one of them where it is near.
struct Reported {
    Nearest<double> nearest;
    double bound = 0;
    bool certain = true;

    explicit operator bool() const { return bool(nearest); }
    const Hit<double>& operator*() const { return *nearest; }
};

std::string text_of(const Reported& reported) {
    return hex((*reported).t) + " ± " + hex(reported.bound) + " of object " +
           std::to_string((*reported).object);
}

Verdict compared(const Reported& reported, std::vector<Expected> expected) {
    std::sort(expected.begin(), expected.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
    bool decided = reported.certain;
    for (const Expected& e : expected) {
        decided = decided && e.certain;
        const double apart = reported ? (*reported).t - e.t : infinity<double>;
        if (reported && (*reported).object == e.object &&
            std::abs(apart) <= std::max(e.bound, reported.bound))
            return {"", decided};
        if (apart < -(e.bound + reported.bound)) break; // reported where nothing is
        if (apart <= e.bound + reported.bound)
            decided = false; // another object's, so close that rounding chose
        else if (e.certain)
            return {"object " + std::to_string(e.object) + " is missed at " + hex(e.t) + " ± " +
                    hex(e.bound) + (reported ? ", reported " + text_of(reported) : "")};
    }
    if (reported && decided) return {"nothing is at " + text_of(reported)};
    return {"", decided};
}

World<double> world_of(const Case& c) {
    SceneBuilder b;
    b.generic(c.shape, c.matrix, b.glowing({1, 1, 1}));
    return build(b.scene());
}

// A plane through the ray's point at a small distance, made by hand after the hit is known.
Mat4d wall_matrix(const Case& c, const Ray<double>& ray) {
    const Vec3d n = normalized(c.wall);
    const Vec3d u = normalized(std::abs(n.x) < 0.5 ? cross(n, {1, 0, 0}) : cross(n, {0, 1, 0}));
    const double step = 4 * c.gap * epsilon<double> * largest_component(absolute(ray.origin));
    Mat4d m = translation(ray.at(step));
    m[0] = {u, 0.0};
    m[1] = {cross(n, u), 0.0};
    m[2] = {n, 0.0};
    return m;
}

void add_wall(World<double>& world, const Mat4d& matrix) {
    world.solids.push_back(placed(Plane<double>{}, matrix));
    world.solids.back().object = 1;
    world.objects.push_back({false, 1, 0, 0, true, Box<double>::everything()});
}

Reported as_reported(const World<double>& world, const Ray<double>& ray, const LeavingSurface<double>& start,
                     const Nearest<double>& nearest, bool inward) {
    Reported reported{nearest};
    if (!nearest) return reported;
    const Hit<double>& hit = *nearest;
    const Solid<double>& solid = world.solids[hit.surface.solid];
    const auto bound_at = [&](double t, int face) {
        return hit.object == 0 ? bound_of(solid, ray, start, t, face) : solid.error_bound(ray, t, face);
    };
    reported.bound = bound_at(hit.t, hit.surface.face);
    if (hit.object != 0) return reported;
    // A start that is met again runs the start's way; what runs the other way so close to it may be rounding's.
    if (hit.entering != inward &&
        (hit.t <= 2 * reported.bound || hugs(solid, ray, start, hit.t, perhaps_start)))
        reported.certain = false;
    std::vector<std::pair<double, double>> ends; // t and bound
    for (const Interval<double>& span : solid.intervals(ray, start.surface.face)) {
        ends.emplace_back(span.enter, bound_at(span.enter, span.enter_face));
        ends.emplace_back(span.exit, bound_at(span.exit, span.exit_face));
    }
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if ((ends[i].first == hit.t || ends[i + 1].first == hit.t) &&
            ends[i + 1].first - ends[i].first <= ends[i].second + ends[i + 1].second)
            reported.certain = false;
    return reported;
}

Verdict judge_start(const Case& c) {
    if (!is_solid(c.shape) || (c.next == Vec3d{0} && c.slope == 0)) return {"", false};
    World<double> world = world_of(c);
    Work<double> work;
    NullRecorder recorder;
    const Leaving<double> nothing;
    const auto hit = Scan<double>(world).closest(c.ray, Range<double>{}, nothing, work, recorder);
    if (!hit) return {"", false};
    const auto at = interact(world, c.ray, hit, nothing, none, work);
    const Vec3d across = c.next - dot(c.next, at.normal) * at.normal;
    const Ray<double> next{at.point, normalized(across + c.slope * at.normal)};
    const bool inward = dot(next.direction, at.normal) < 0;
    const bool stays = inward == (dot(at.facing, at.normal) < 0);
    const Leaving<double>& leaving = stays ? at.back : at.through;
    const LeavingSurface<double>& start = leaving.items[0];

    std::vector<Expected> expected = beyond_start(c, world.solids[0], next, start, inward);
    if (c.wall != Vec3d{0}) {
        const Mat4d matrix = wall_matrix(c, next);
        add_wall(world, matrix);
        expected.push_back(at_wall(world, matrix, next));
        if (!expected.back().certain) return {"", false};
    }
    const auto again = Scan<double>(world).closest(next, Range<double>{}, leaving, work, recorder);
    return compared(as_reported(world, next, start, again, inward), std::move(expected));
}

void expect_clean_starts(int cases) {
    for (const Generic<double>& shape : solid_generics())
        expect_of_cases(
            generic_name(shape), cases, 0.2, [&](Random& random) { return draw_case(shape, random); },
            judge_start);
}

TEST(Reintersection, a_start_is_not_met_again_and_hides_nothing) { expect_clean_starts(samples(5000)); }
TEST(ReintersectionFull, a_start_is_not_met_again_and_hides_nothing) {
    expect_clean_starts(samples(1000000));
}

} // namespace
} // namespace rayscope::test
