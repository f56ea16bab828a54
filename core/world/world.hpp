#pragma once
// What the tracer reads: flat arrays of values, names gone, indices instead of pointers.

#include "core/csg/truth_table.hpp"
#include "core/math/box.hpp"
#include "core/refraction/dispersion.hpp"
#include "core/trace/events.hpp"
#include "core/world/effect_set.hpp"
#include "core/world/light_area.hpp"
#include "core/world/media.hpp"
#include "core/world/pattern.hpp"
#include "core/world/solid.hpp"

namespace rayscope {

/// What says how much of the light a boundary reflects.
enum class Mirror : std::uint8_t {
    constant, ///< the coefficients reflection and transmission
    fresnel,  ///< Fresnel's equations: R, and 1 − R goes through
    schlick,  ///< Schlick's approximation of them
};

struct Material {
    Colour ambient{0}, diffuse{0}, specular{0};
    double shininess = 1;
    Colour reflection{0}, transmission{0};
    double speed = 1; ///< of light inside; air 1; of a medium that spreads colours, at the helium d line
    // What the classic tracer does not read.
    Mirror mirror = Mirror::constant;
    Colour absorption{0}; ///< of light inside: it is multiplied by exp(−absorption · length)
    Dispersion dispersion{};
    Id patterns = none; ///< index into World::patterns

    [[nodiscard]] bool absorbs() const { return largest_component(absorption) > 0; }
    /// @param wavelength nm; 0: the speed of all colours together
    [[nodiscard]] double speed_at(double wavelength) const {
        return wavelength > 0 && dispersion.spreads() ? 1 / dispersion.index(wavelength) : speed;
    }
    [[nodiscard]] bool transmits() const { return largest_component(transmission) > 0; }
};

struct Light {
    bool directional = false;
    Vec3d position{0}; ///< or the unit direction towards a directional light
    Colour colour{1};
    bool shadows = true;
    LightArea area;
};

struct Compound {
    std::vector<CompoundNode> nodes; ///< the author's tree in postfix order
    Program program;                 ///< the same, regrouped
    std::vector<PartExtent> extents; ///< around parts of it
    TruthTable table;                ///< where it has few operands, and no ray enters one of them twice
    double size = 0;                 ///< the largest coordinate of the extents
};

/// What a ray can hit: a solid, or a compound of solids. Its index is its id, in the order of the file.
struct Object {
    bool is_compound = false;
    std::uint32_t index = 0;    ///< into solids or compounds
    std::uint32_t material = 0; ///< reflection, transmission and speed
    std::int32_t priority = 0;  ///< of its medium, where media overlap
    bool has_volume = true;     ///< false for polygons and open walls
    Box<double> bounds;         ///< rounded outward
};

/// The part of a world that is the same in all numbers.
struct WorldBase {
    std::vector<Compound> compounds;
    std::vector<Object> objects;
    std::vector<Material> materials;
    std::vector<Patterns> patterns;
    std::vector<Light> lights;
    MediaNeighbours media;

    EffectMask effects = EffectMask::classic; ///< what drawn materials and the lights ask for
    bool absorbs = false;                     ///< some medium does

    /// Counts in what a material asks for that something drawn has, as a whole or as a wall.
    void note_effects(std::uint32_t material, bool has_inside) {
        const Material& m = materials[material];
        const bool is_medium = has_inside && m.transmits();
        absorbs = absorbs || (is_medium && m.absorbs());
        if (m.mirror != Mirror::constant || m.patterns != none) effects = EffectMask::all;
        if (is_medium && (m.absorbs() || m.dispersion.spreads())) effects = EffectMask::all;
    }

    Colour background{0}, ambient{1};
    bool notes_media = false;
    double medium_speed = 1; ///< between the solids
    int max_depth = 8;
    double min_weight = 0.001;
    int max_rays = 100000;
    int wavelengths = 8; ///< behind a boundary that spreads colours

    [[nodiscard]] const Material& material_of(const Object& object) const {
        return materials[object.material];
    }
    [[nodiscard]] const Material& material_of(std::uint32_t object) const {
        return material_of(objects[object]);
    }
};

/// What the kernel of a plain ball reads, in one line of the cache: a Solid takes up several, and among 10⁵ of them each
/// is far away.
template <Numbers N> struct alignas(64) Ball {
    using T = ScalarOf<N>;
    static constexpr std::uint32_t no_ball = ~std::uint32_t(0);

    Vec3<T> centre{T(0)};
    Sphere<N> sphere;
    std::uint32_t solid = no_ball; ///< index into World::solids

    /// See Solid.
    [[nodiscard]] Intervals<T> intervals(const Ray<T>& ray) const {
        return sphere.intervals({ray.origin - centre, ray.direction});
    }
    [[nodiscard]] Surface surface(int face) const { return {solid, std::int32_t(face), false}; }
};

template <Numbers N> struct World : WorldBase {
    std::vector<Solid<N>> solids;
    std::vector<Ball<N>> balls; ///< by object, as many as have copies: none where few are balls

    /// Nothing where the object is no ball, or has no copy: then its solid is to be asked.
    [[nodiscard]] const Ball<N>* ball_of(std::uint32_t object) const {
        return object < balls.size() && balls[object].solid != Ball<N>::no_ball ? &balls[object] : nullptr;
    }

    /// A plain solid that is a sphere at its place in world space.
    [[nodiscard]] bool is_ball(const Object& object) const {
        return !object.is_compound && solids[object.index].is_ball;
    }
};

} // namespace rayscope
