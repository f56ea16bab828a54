#include "bench/peers/embree/embree_scene.hpp"

#include <chrono>
#include <stdexcept>

#include <embree3/rtcore.h>

namespace rayscope::bench {
namespace {

struct Ball {
    float x, y, z, radius;
};

const Ball& ball_of(void* balls, unsigned primitive) { return static_cast<const Ball*>(balls)[primitive]; }

void bounds(const RTCBoundsFunctionArguments* a) {
    const Ball& b = ball_of(a->geometryUserPtr, a->primID);
    *a->bounds_o = {b.x - b.radius, b.y - b.radius, b.z - b.radius, 0,
                    b.x + b.radius, b.y + b.radius, b.z + b.radius, 0};
}

// Where a ray of unit direction enters, or else leaves, within its range; negative if nowhere.
float meet(const Ball& b, const RTCRay& r) {
    const float x = b.x - r.org_x, y = b.y - r.org_y, z = b.z - r.org_z;
    const float middle = x * r.dir_x + y * r.dir_y + z * r.dir_z;
    const float px = x - middle * r.dir_x, py = y - middle * r.dir_y, pz = z - middle * r.dir_z;
    const float squared = b.radius * b.radius - (px * px + py * py + pz * pz);
    if (!(squared >= 0)) return -1;
    const float half = std::sqrt(squared);
    const float t = middle - half > r.tnear ? middle - half : middle + half;
    return t > r.tnear && t < r.tfar ? t : -1;
}

void intersect(const RTCIntersectFunctionNArguments* a) {
    if (a->valid[0] == 0) return;
    auto& found = *reinterpret_cast<RTCRayHit*>(a->rayhit);
    const float t = meet(ball_of(a->geometryUserPtr, a->primID), found.ray);
    if (t < 0) return;
    found.ray.tfar = t;
    found.hit.geomID = a->geomID;
    found.hit.primID = a->primID;
}

void occluded(const RTCOccludedFunctionNArguments* a) {
    if (a->valid[0] == 0) return;
    auto& ray = *reinterpret_cast<RTCRay*>(a->ray);
    if (meet(ball_of(a->geometryUserPtr, a->primID), ray) >= 0)
        ray.tfar = -std::numeric_limits<float>::infinity();
}

RTCRay ray_of(const Ray<double>& from, double length, float farthest) {
    RTCRay ray{};
    ray.org_x = float(from.origin.x), ray.org_y = float(from.origin.y), ray.org_z = float(from.origin.z);
    ray.dir_x = float(from.direction.x / length), ray.dir_y = float(from.direction.y / length),
    ray.dir_z = float(from.direction.z / length);
    ray.tfar = farthest;
    ray.mask = ~0U;
    return ray;
}

} // namespace

struct EmbreeScene::Parts {
    RTCDevice device = rtcNewDevice("threads=1,user_threads=1,set_affinity=0");
    RTCScene scene = rtcNewScene(device);
    std::vector<Ball> balls;
    double build_seconds = 0;

    void finish(RTCGeometry geometry) {
        const auto begin = std::chrono::steady_clock::now();
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene);
        build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
};

EmbreeScene::EmbreeScene(const World<double>& world) : parts_(std::make_unique<Parts>()) {
    for (const Object& object : world.objects) {
        if (!world.is_ball(object)) continue;
        const Solid<double>& ball = world.solids[object.index];
        const auto centre = as<float>(ball.transform.translation());
        parts_->balls.push_back(
            {centre.x, centre.y, centre.z, float(std::get<Sphere<double>>(ball.shape).radius)});
    }
    const RTCGeometry geometry = rtcNewGeometry(parts_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(parts_->balls.size()));
    rtcSetGeometryUserData(geometry, parts_->balls.data());
    rtcSetGeometryBoundsFunction(geometry, bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcSetGeometryOccludedFunction(geometry, occluded);
    parts_->finish(geometry);
}

EmbreeScene::EmbreeScene(const Triangles& mesh) : parts_(std::make_unique<Parts>()) {
    const RTCGeometry geometry = rtcNewGeometry(parts_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto copy = [&](RTCBufferType type, RTCFormat format, const auto& list) {
        void* const buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(list[0]), list.size());
        if (buffer == nullptr) throw std::runtime_error("Embree has no room for the triangles");
        std::copy(list.begin(), list.end(), static_cast<std::decay_t<decltype(list[0])>*>(buffer));
    };
    copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.corners);
    copy(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.indices);
    parts_->finish(geometry);
}

EmbreeScene::~EmbreeScene() {
    if (!parts_) return;
    rtcReleaseScene(parts_->scene);
    rtcReleaseDevice(parts_->device);
}
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;

RaySum EmbreeScene::nearest(const std::vector<Ray<double>>& rays) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RaySum sum;
    for (const Ray<double>& ray : rays) {
        RTCRayHit found{};
        found.ray = ray_of(ray, 1, std::numeric_limits<float>::infinity());
        found.hit.geomID = found.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(parts_->scene, &context, &found);
        if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) continue;
        ++sum.hits;
        sum.distance += double(found.ray.tfar);
    }
    return sum;
}

RaySum EmbreeScene::blocked(const std::vector<Ray<double>>& rays) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RaySum sum;
    for (const Ray<double>& from : rays) {
        const double length = rayscope::length(from.direction);
        RTCRay ray = ray_of(from, length, float(length));
        rtcOccluded1(parts_->scene, &context, &ray);
        if (ray.tfar < 0) ++sum.hits;
    }
    return sum;
}

double EmbreeScene::build_seconds() const { return parts_->build_seconds; }

} // namespace rayscope::bench
