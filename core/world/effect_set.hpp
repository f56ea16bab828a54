#pragma once
// What a scene may call for, and a set of that.

#include <array>
#include <bitset>
#include <cstdint>
#include <string_view>

namespace rayscope {

/// In the order in which they are listed for a person: the notes' first.
enum class Effect : std::uint8_t {
    ambient,
    diffuse,
    specular,
    shadows,
    reflection,
    refraction,   ///< rays that go through, bent or not
    nested_media, ///< what is outside of a medium is another one
    soft_shadows, ///< lights with an area
    fresnel,      ///< how much a dielectric reflects depends on the angle
    absorption,   ///< a medium swallows light on its way
    dispersion,   ///< a medium bends each colour differently
    antialiasing, ///< more than one sample in a pixel
    patterns,     ///< coefficients that change over a surface
};

/// By Effect.
struct EffectName {
    std::string_view name, meaning;
};
inline constexpr std::array<EffectName, 13> effect_names{
    {{"ambient", "light that is everywhere"},
     {"diffuse", "light scattered by a dull surface"},
     {"specular", "highlights of the lights"},
     {"shadows", "a ray to each light finds what stands between"},
     {"reflection", "mirrored rays"},
     {"refraction", "rays that go through"},
     {"nested_media", "media within or beside other media"},
     {"soft_shadows", "several rays to each light that has an area"},
     {"fresnel", "reflected share by Fresnel's equations"},
     {"absorption", "light lost on the way through a medium"},
     {"dispersion", "the spectrum behind a boundary that spreads it"},
     {"antialiasing", "more samples where neighbouring pixels differ"},
     {"patterns", "coefficients that change over a surface"}}};

class EffectSet {
public:
    EffectSet() = default;

    [[nodiscard]] bool has(Effect effect) const { return bits_.test(std::size_t(effect)); }
    EffectSet& set(Effect effect, bool on = true) {
        bits_.set(std::size_t(effect), on);
        return *this;
    }
    [[nodiscard]] bool operator==(const EffectSet&) const = default;
    [[nodiscard]] friend EffectSet united(EffectSet a, const EffectSet& b) {
        a.bits_ |= b.bits_;
        return a;
    }

private:
    std::bitset<effect_names.size()> bits_;
};

/// Which of the tracer's two forms a world needs. Where nothing asks for an added effect both give the same bits.
enum class EffectMask : std::uint8_t {
    classic, ///< the notes' effects and media by priority
    all,
};

} // namespace rayscope
