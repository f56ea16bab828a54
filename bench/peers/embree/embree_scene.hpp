#pragma once
// Embree, asked one ray at a time, in float.

#include "bench/support/ray_sets.hpp"

#include <array>
#include <memory>

namespace rayscope::bench {

struct Triangles {
    std::vector<Vec3<float>> corners;
    std::vector<std::array<std::uint32_t, 3>> indices;
};

class EmbreeScene {
public:
    /// All balls of a world, as user geometry: Embree's boxes, and a test of ours in its callback.
    explicit EmbreeScene(const World<double>& world);
    explicit EmbreeScene(const Triangles& mesh);
    ~EmbreeScene();
    EmbreeScene(EmbreeScene&&) noexcept;

    [[nodiscard]] RaySum nearest(const std::vector<Ray<double>>& rays) const;
    /// Something with 0 < t < 1.
    [[nodiscard]] RaySum blocked(const std::vector<Ray<double>>& rays) const;
    [[nodiscard]] double build_seconds() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

} // namespace rayscope::bench
