#pragma once
// What each effect costs and changes, measured.

#include "core/effects/effect_needs.hpp"
#include "core/image/image.hpp"
#include "core/tracer/render.hpp"

namespace rayscope {

struct EffectCost {
    Effect effect = Effect::ambient;
    bool taken_away = false; ///< from the scene, which calls for it; else added to it
    double time_ratio = 1;   ///< of the image with it to that without, the median of the rounds
    double least_ratio = 1, greatest_ratio = 1;
    double difference = 0;              ///< mean CIEDE2000 between the two images
    double similarity = 1;              ///< their SSIM; NaN below 11 × 11 pixels
    Colour light{0};                    ///< mean light of the image with it minus that without
    std::array<std::int64_t, 4> rays{}; ///< by RayKind: those with it minus those without
    Image image;                        ///< with the effect added, or without the one taken away
};

struct EffectCosts {
    Image scene; ///< as it is
    std::vector<EffectCost> effects;
    std::vector<Effect> nowhere; ///< could be added to nothing in the scene
    bool complete = true;        ///< not stopped
};

struct EffectCostOptions {
    RenderOptions render;
    int rounds = 5;
};

/// Renders the scene as it is and with each effect changed in turn, A B C A B C …, so that a machine that slows down
/// slows all of them down.
[[nodiscard]] EffectCosts effect_costs(const Scene& scene, const EffectSet& needed,
                                       const EffectCostOptions& options);

/// Three pictures beside each other: with the effect, without it, and eight times their difference around grey.
[[nodiscard]] Image strip(const EffectCosts& costs, const EffectCost& cost);

} // namespace rayscope
