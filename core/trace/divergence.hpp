#pragma once
// Where two runs of the same ray part: the first answer on which they disagree.
//
// Answers are compared, not visits: what was tested in which order, by which bound, with which surface to be left, is a
// run's own affair. How many spans each object has on the ray, what is hit, what is seen of each light, and which rays
// follow is not.

#include "core/math/numbers.hpp"
#include "core/trace/trace.hpp"

namespace rayscope {

/// What both runs were asked. Of the first group any difference is a divergence; the others are numbers.
enum class Answer : std::uint8_t {
    spans,         ///< how many a node of an object has on the ray's line
    hit,           ///< something or nothing
    object,        ///< whose boundary is the nearest
    face,          ///< which surface of it
    side,          ///< whether the ray enters or leaves
    media,         ///< from which into which
    local_light,   ///< lit, or left out
    shadow_ray,    ///< whether a light is asked for at all
    total,         ///< total internal reflection, or none
    followed,      ///< whether a reflected or refracted ray goes on; and if not, why
    given,         ///< what the scene gives: a colour or a coefficient
    weight,        ///< the share of the pixel that a ray carries
    share,         ///< of the light, that is mirrored or goes through, where that is calculated (Fresnel)
    origin,        ///< of the first ray
    direction,     ///< of any ray
    t,             ///< of the hit
    normal,        ///< unit, outward; shown, never judged: nothing is recorded that bounds it
    cosine,        ///< between normal and light
    mirror_cosine, ///< between the mirrored light and the way back
    visibility,    ///< what blockers leave of a light
};

/// One answer in both runs.
struct Difference {
    Answer answer = Answer::t;
    int ray = 0;                 ///< its number is the same in both: until they part, their trees agree
    RayKind next = RayKind::eye; ///< followed, direction: of the ray itself, or of which that it spawns
    Id light = none;             ///< shadow_ray and cosines: the same in both
    std::string object = {};     ///< spans: its name, …
    Id node = none;              ///< … and the node's index
    std::string_view what = {};  ///< given: what
    Vec3d first{0}, second{0};   ///< numbers and counts; those of one component stand in x
    bool is_vector = false;
    double size = 0;              ///< the largest component of |first − second|
    double ulps = 0;              ///< the same in ulps of the narrower type
    double explained = 0;         ///< the most that both runs' precision explains; ∞: not judged
    double bounds = not_a_number; ///< t: the error bounds of both runs, added
};

struct Comparison {
    std::optional<Difference> divergence;
    std::optional<Difference> largest; ///< in ulps, of the harmless ones before it
    int rays = 0;                      ///< that were compared, the last one perhaps in part
    bool complete = true;              ///< false: a record was full, and nothing is known beyond
};

/// The first divergence of two traces of the same ray of the same scene, in the order of events.
///
/// A number diverges where it differs by more than the step that made it explains: by its rounding in both runs (of a hit:
/// the error bounds), and by what the differences that the step already began with can do to it. So a run is not blamed for
/// what an earlier step did. A run without bounds (the schoolbook's) is granted those of the other, brought to its ε.
[[nodiscard]] Comparison compare(const Trace& first, const Trace& second, Precision of_first,
                                 Precision of_second);

} // namespace rayscope
