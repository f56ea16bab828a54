#include "visualizer/drawing/framing.hpp"

#include "visualizer/drawing/ray_path.hpp"

#include <algorithm>
#include <numbers>

namespace rayscope::drawing {
namespace {

constexpr double eye_within = 1.8; // radii of the region: a nearer eye is in the picture

constexpr double path_within = 8; // … as is this much of the current ray's path

/// A stretch of a ray near the region, and how much it matters.
struct Stretch {
    Vec3d from, to;
    double importance;
};

std::vector<Stretch> stretches(const Trace& trace, const Region& region) {
    std::vector<Stretch> found;
    for (const TracedRay& ray : trace.rays) {
        const RaySpawned& start = ray.start();
        const bool eye = ray.parent == none;
        if (!region.holds(start.origin, 3) && !eye) continue;
        const bool shadow = start.kind == RayKind::shadow;
        const RayEnd end = drawn_end(ray, region.open_length());
        Vec3d from = start.origin, to = end.point;
        if (!region.holds(to, 1.5)) to = from + normalized(to - from) * (0.45 * region.radius);
        if (!region.holds(from, eye_within)) from = to + normalized(from - to) * (0.9 * region.radius);
        found.push_back({from, to, (eye ? 1.5 : 1.0) * (shadow ? 0.15 : 1.0) * std::pow(weight(ray), 0.35)});
        if (found.size() > 2000) break;
    }
    return found;
}

std::vector<Vec3d> interesting_points(const std::vector<Stretch>& rays, const Trace& trace,
                                      const Region& region) {
    std::vector<Vec3d> points;
    for (const Stretch& ray : rays) {
        if (!(ray.importance > 0.15)) continue;
        points.push_back(ray.from);
        points.push_back(ray.to);
    }
    for (const Box<double>& box : region.boxes) {
        // The middles of a box's faces lie on a sphere, a cylinder and their like; the corners do not.
        const Vec3d middle = box.low + (box.high - box.low) / 2.0, half = (box.high - box.low) / 2.0;
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                Vec3d p = middle;
                p[axis] += side * half[axis];
                points.push_back(p);
            }
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3d signs{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1};
            points.push_back(middle + half * signs * 0.75);
        }
    }
    for (const TraceLight& light : trace.lights)
        if (!light.directional && region.holds(light.position, 2)) points.push_back(light.position);
    if (points.empty()) points = {region.centre - Vec3d{region.radius}, region.centre + Vec3d{region.radius}};
    return points;
}

/// Outward normals of the half spaces that cut or touch the region: the camera should stand outside of them.
std::vector<Vec3d> walls(const Scene& scene, const Region& region) {
    std::vector<Vec3d> normals;
    for (const SceneObject& object : scene.drawn) {
        if (object.is_compound || normals.size() > 100) continue;
        const SceneGeneric& generic = scene.generics[object.index];
        if (!std::holds_alternative<Plane<double>>(generic.shape)) continue;
        const Vec3d normal = Transform<double>(generic.matrix).normal_to_world({0, 0, 1});
        if (std::abs(dot(region.centre - Vec3d(generic.matrix[3]), normal)) < 3 * region.radius)
            normals.push_back(normal);
    }
    return normals;
}

/// How far apart the rays' ends appear across the direction in which they appear farthest apart: 0 (on a line) to 1.
double separation(const Vec3d& right, const Vec3d& up, const std::vector<Stretch>& rays) {
    double weights = 0, xx = 0, xy = 0, yy = 0;
    Vec3d middle{0};
    for (const Stretch& ray : rays) {
        middle += (ray.from + ray.to) * (ray.importance / 2);
        weights += ray.importance;
    }
    if (!(weights > 0)) return 0;
    middle /= weights;
    for (const Stretch& ray : rays)
        for (const Vec3d& end : {ray.from, ray.to}) {
            const double x = dot(end - middle, right), y = dot(end - middle, up);
            xx += ray.importance * x * x;
            xy += ray.importance * x * y;
            yy += ray.importance * y * y;
        }
    // The two eigenvalues of their covariance.
    const double half = (xx + yy) / 2, apart = std::hypot((xx - yy) / 2, xy);
    return half > 0 ? std::sqrt(std::max(half - apart, 0.0) / (half + apart)) : 0;
}

/// How well the rays can be followed from there: their lengths as seen, against lines of sight through walls.
double score(const Vec3d& back, const Vec3d& up, const std::vector<Stretch>& rays,
             const std::vector<Vec3d>& planes) {
    double seen = 0, all = 0;
    for (const Stretch& ray : rays) {
        const Vec3d d = ray.to - ray.from;
        const double along = dot(d, back), size = length(d);
        seen += ray.importance * std::sqrt(std::max(size * size - along * along, 0.0));
        all += ray.importance * size;
    }
    double result = all > 0 ? seen / all : 0;
    for (const Vec3d& normal : planes)
        if (dot(normal, back) < 0.08) result -= dot(normal, up) > 0.7 ? 1 : 0.06;
    const Vec3d right = normalized(cross(up, back));
    result += 0.4 * separation(right, normalized(cross(back, right)), rays);
    if (!rays.empty() && dot(rays.front().to - rays.front().from, right) > 0)
        result += 0.03; // reads left to right
    return result;
}

Vec3d upward(const Scene& scene) {
    const Vec3d up = normalized(scene.camera.up);
    return length(up) > 0 && std::isfinite(length(up)) ? up : Vec3d{0, 1, 0};
}

} // namespace

View framed(const Trace& trace, const Scene& scene, const Region& region, const Area& area, int chosen) {
    const std::vector<Stretch> rays = stretches(trace, region);
    const std::vector<Vec3d> planes = walls(scene, region);
    const Vec3d up = upward(scene);
    const Vec3d aside = absolute(up).x < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 0, 1};
    const Vec3d east = normalized(cross(up, aside)), north = cross(up, east);
    Vec3d best = normalized(east + up * 0.4);
    double best_score = -infinity<double>;
    for (const double elevation : {14.0, 24.0, 36.0, 50.0})
        for (int step = 0; step < 36; ++step) {
            const double a = step * 10 * std::numbers::pi / 180, e = elevation * std::numbers::pi / 180;
            const Vec3d back =
                normalized((east * std::cos(a) + north * std::sin(a)) * std::cos(e) + up * std::sin(e));
            const double s = score(back, up, rays, planes) - std::abs(elevation - 22) * 0.003;
            if (s > best_score) {
                best_score = s;
                best = back;
            }
        }
    std::vector<Vec3d> points = interesting_points(rays, trace, region);
    for (const int i : path_to(trace, chosen)) {
        const TracedRay& ray = trace.rays[std::size_t(i)];
        if (ray.parent != none && region.holds(ray.start().origin, path_within))
            points.push_back(ray.start().origin);
        if (const auto* hit = ray.find<BoundaryChosen>();
            hit != nullptr && region.holds(hit->point, path_within))
            points.push_back(hit->point);
    }
    return {region, area, best, up, points, 0.86};
}

} // namespace rayscope::drawing
