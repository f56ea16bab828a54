#pragma once
// Where the light of a sample came from, and what was dropped on the way.

#include "core/trace/trace.hpp"

#include <map>

namespace rayscope {

enum class LightKind : std::uint8_t { ambient, diffuse, specular, background };
inline constexpr std::string_view light_kind_names[] = {"ambient", "diffuse", "specular", "background"};

/// Of which kind is a light, from which object, brought by which kind of ray.
struct LightSource {
    LightKind kind = LightKind::ambient;
    RayKind brought_by = RayKind::eye;
    Id object = none; ///< none: the background
    auto operator<=>(const LightSource&) const = default;
};

/// Rays that were not followed. Their weights say how much light can be missing: at most so many times the brightest.
struct DroppedRays {
    int count = 0;
    Colour weight{0}; ///< sum of theirs, per colour: rays of single wavelengths share theirs out
};

struct Ledger {
    std::map<LightSource, Colour> sources; ///< as it arrives at the eye: they add up to `total`
    std::map<std::pair<RayKind, Reason>, DroppedRays> dropped;
    /// What would have arrived besides, had no medium on the rays' way from the eye swallowed any.
    Colour absorbed{0};
    Colour total{0};
};

/// Of one sample: its rays, root first. Objects are those that the events name.
[[nodiscard]] Ledger ledger_of(const std::vector<TracedRay>& rays);

/// Of several samples or pixels together.
Ledger& operator+=(Ledger& sum, const Ledger& more);

/// What was added up `parts` times becomes the mean; rays stay counted.
Ledger& operator/=(Ledger& sum, double parts);

} // namespace rayscope
