#pragma once
// What happens to a ray, one small struct for each decision. Ids only: names are looked up when a person reads them.

#include "core/math/vec.hpp"

#include <cstdint>
#include <limits>
#include <variant>

namespace rayscope {

/// Index into one of the tables of a Trace (objects, nodes, lights, media); none = −1.
using Id = std::int32_t;
inline constexpr Id none = -1;
inline constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

enum class RayKind : std::uint8_t { eye, reflected, refracted, shadow };

/// Why a ray was not followed any further.
enum class Reason : std::uint8_t {
    coefficient_zero,          ///< the material does not reflect (or transmit)
    depth,                     ///< depth has reached max_depth
    weight,                    ///< the new ray's weight would be below min_weight
    total_internal_reflection, ///< no refracted direction exists
    ray_limit,                 ///< the sample has spent its max_rays
    leaves_solid,              ///< no local light where a ray leaves a transmitting solid
};

/// How hits are found: a rung of the ladder.
enum class StageKind : std::uint8_t {
    scan,       ///< every object
    extents,    ///< every object's box first
    projective, ///< what a tile of the screen shows: eye rays
    light,      ///< what a light sees in a cell: shadow rays
    octree,
    bvh,
};

/// What a stage keeps objects in, or passes on the way to them.
enum class PlaceKind : std::uint8_t {
    extent,     ///< the box of one object
    tile,       ///< of the screen
    light_cell, ///< of a light's view
    entry,      ///< of a tile's or a light cell's list: one object
    cell,       ///< of the octree, or a leaf of the bvh: objects
    node,       ///< of the octree or the bvh: cells and nodes
    part,       ///< the box of a part of a compound: some of its generics
};

/// Why a search came to its end.
enum class SearchEnd : std::uint8_t {
    nothing_left, ///< every place on the ray's way was looked into
    beyond_reach, ///< all places left begin beyond the nearest hit, or beyond the light
    blocked,      ///< something opaque was found
    covered,      ///< a light's cell is covered by an opaque object nearer to the light
};

/// One end of an inside interval as it is recorded. An unbounded end has t = ±inf and leaf none.
struct Boundary {
    double t = 0;
    Id leaf = none;       ///< the generic whose surface it is: index into Trace::generics
    int face = 0;         ///< which of its faces (see generics)
    bool flipped = false; ///< the surface belongs to a subtracted part: its normal is turned
};

/// A ray starts.
struct RaySpawned {
    RayKind kind = RayKind::eye;
    int depth = 0;
    Colour weight{1}; ///< share of the pixel that the ray carries, per colour; the largest is "the" weight
    Vec3d origin{0}, direction{0}; ///< as traced: unit, but for a ray given by hand before it is normalized
    double reach = 0;      ///< crossings beyond this t do not count (shadow rays: distance to the light)
    Id medium = none;      ///< the medium it travels in: index into Trace::media
    Id light = none;       ///< shadow rays: the light that they ask for
    Id left_object = none; ///< secondary rays: the object whose surface they leave …
    double left_bound = 0; ///< … and how far, at most, the start may lie from it (world length)
    double wavelength = 0; ///< nm, behind a boundary that spreads colours; 0: the ray carries all of them
};

/// A stage begins to look for what the ray hits. Recorded only where a stage was asked for.
struct SearchBegan {
    StageKind stage = StageKind::scan;
    int objects = 0; ///< in the whole world
};

/// The ray comes to a place; what is tested in it follows. Places of a tree that it passes by are not recorded.
struct PlaceEntered {
    PlaceKind kind = PlaceKind::cell;
    Id place = none;  ///< its number in the stage
    int level = 0;    ///< its depth below the root of a tree
    Id object = none; ///< extents, entries and parts: the object
    int held = 0;     ///< objects in it; of a node: children that are not empty; of a part: generics
    Vec3d low{0},
        high{
            0}; ///< its box in world space; of a tile its first and last pixel; of a light's cell column and row
    double t_in = 0,
           t_out = 0; ///< where the ray is in it; of an entry t_in: none of its object's crossings is nearer
};

/// The objects of a place were looked through.
struct PlaceLeft {
    int tested = 0; ///< for the first time in this search
    int spared = 0; ///< of those held: tested before, or not needed any more
};

struct SearchEnded {
    SearchEnd reason = SearchEnd::nothing_left;
    double t = 0;   ///< beyond it nothing was looked for
    int places = 0; ///< cells and lists that were looked into
    int missed = 0; ///< extents that the ray missed
    int tested = 0; ///< objects tested
    int spared = 0; ///< objects of the world that needed no test
};

/// An object was tested and has a crossing that counts. Objects without one are only counted (RayFinished).
struct ObjectAccepted {
    Id object = none;
    double t = 0;
};

/// The inside list of one node of an object on this ray has `count` spans; that many SpanFound follow.
/// A plain generic is node 0 of its object.
struct NodeEvaluated {
    Id object = none;
    Id node = none; ///< index into Trace::objects[object].nodes
    int count = 0;
};

struct SpanFound {
    Boundary enter, exit;
};

/// At the root of a compound, `count` crossings from t_first to t_last lie within their error bounds of each other:
/// an odd cluster keeps one crossing, an even one vanishes.
struct ClusterMerged {
    Id object = none;
    int count = 0;
    double t_first = 0, t_last = 0;
    bool kept = false;
};

/// The nearest crossing, and what the shading needs to know of it.
struct BoundaryChosen {
    Id object = none;
    Boundary boundary;
    bool entering = false;
    double error_bound = 0; ///< |t − exact t| is at most this
    Vec3d point{0};
    Vec3d normal{0}; ///< unit, outward from the object
    Vec3d facing{0}; ///< the normal turned against the ray
    Id medium_from = none, medium_to = none;
    double speed_from = 1, speed_to = 1;
};

/// Follows a BoundaryChosen on a mesh: which triangle it is, and where in it.
struct TriangleHit {
    int triangle = 0;                             ///< in the order of the file, from 0
    int corner_a = 0, corner_b = 0, corner_c = 0; ///< its vertices, by the numbers that the file gives them
    Vec3d shares{0}; ///< barycentric coordinates: the point is a share of each corner; they add up to 1
};

/// Nothing was hit; the background is added.
struct Missed {
    Colour background{0};
};

struct AmbientLit {
    Colour scene{0}, material{0}; ///< the term is their product
};

/// What a medium leaves of the light on the way that a ray made in it, up to its end or the next boundary.
struct Absorbed {
    Id medium = none;
    double length = 0;
    Colour passed{1}; ///< exp(−absorption · length)
};

/// The diffuse and the specular term of one light, or of one of the points that stand for a light with an area.
struct LightLit {
    Id light = none;
    Vec3d to_light{0};        ///< unit
    double cosine = 0;        ///< n·l; the light is behind the surface if it is not positive
    double mirror_cosine = 0; ///< r·v
    double shininess = 0;
    int sample = 0, samples = 1; ///< which point of the light's area, and of how many
    Colour intensity{0};         ///< of the light, or this point's part of it
    Colour visibility{1};        ///< what blockers leave of it
    Colour diffuse_coefficient{0}, specular_coefficient{0};
    Colour diffuse{0}, specular{0}; ///< the two terms
};

struct LocalLightSkipped {
    Reason reason = Reason::leaves_solid;
};

/// A boundary between the point and a light: the light is multiplied by the transmission.
struct BlockerPassed {
    Id object = none;
    double t = 0;
    Colour transmission{0};
};

/// How much a boundary with Fresnel's coefficients reflects; what it does not, goes through.
struct FresnelShared {
    double perpendicular = 0, parallel = 0; ///< Fresnel's Rs and Rp
    double schlick = 0;                     ///< Schlick's approximation of their mean
    double reflected = 0;                   ///< the one that counts here
    double wavelength = 0;                  ///< nm; 0: all
};

/// The mirrored direction and its share. The child ray follows as the next child of this ray, unless refused.
struct Reflected {
    Colour coefficient{0};
    double theta = 0; ///< radians, between ray and normal, on both sides alike
    Vec3d direction{0};
};

struct Refracted {
    Colour coefficient{0};
    double theta_from = 0, theta_to = 0; ///< radians
    double critical = not_a_number;      ///< radians; NaN if this pair of media has none
    double eta = 1;                      ///< speed_to / speed_from
    Vec3d direction{0};
    double wavelength = 0; ///< nm; 0: all
};

/// No refracted ray exists; one mirrored ray carries reflection + transmission.
struct TotallyReflected {
    Colour coefficient{0};
    double theta_from = 0, critical = 0;
    double eta = 1;
    double wavelength = 0; ///< nm; 0: all
};

/// A ray that was considered and not followed.
struct NotSpawned {
    RayKind kind = RayKind::reflected;
    Reason reason = Reason::coefficient_zero;
    double coefficient = 0; ///< largest component
    Colour weight{0};       ///< what the ray's weight would have been
};

/// A ray's end: the colour that it brings back, before its parent's coefficient.
struct RayFinished {
    Colour local{0};  ///< ambient + diffuse + specular (or the background)
    Colour colour{0}; ///< local + all that its children brought
    int tested = 0;   ///< objects tested
    int rejected = 0; ///< … of which without a crossing that counts
};

/// The cap on events was met: from here on nothing more is kept, in this ray or in any other.
struct Truncated {
    int kept = 0; ///< events in the whole trace
};

using Event = std::variant<RaySpawned, SearchBegan, PlaceEntered, PlaceLeft, SearchEnded, ObjectAccepted,
                           NodeEvaluated, SpanFound, ClusterMerged, BoundaryChosen, TriangleHit, Missed,
                           Absorbed, AmbientLit, LightLit, LocalLightSkipped, BlockerPassed, FresnelShared,
                           Reflected, Refracted, TotallyReflected, NotSpawned, RayFinished, Truncated>;

} // namespace rayscope
