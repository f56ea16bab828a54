#pragma once
// The recursion.

#include "core/reflection/mirror.hpp"
#include "core/shading/phong.hpp"
#include "core/stage/ray_use.hpp"
#include "core/tracer/added_effects.hpp"
#include "core/tracer/budget.hpp"
#include "core/tracer/interaction.hpp"
#include "core/tracer/order.hpp"
#include "core/tracer/recording.hpp"

namespace rayscope {

/// What an eye ray met first: what antialiasing compares with that of the neighbours.
struct FirstSeen {
    Id object = none;
    Vec3d normal{0};       ///< unit, against the ray
    bool penumbra = false; ///< it sees a part of a light: how much of it is told by few points
};

/// Light, by the kind of the rays that bring it to the eye.
struct BroughtLight {
    std::array<Colour, 3> by_kind; ///< eye, reflected, refracted

    void clear() { by_kind.fill(Colour{0}); }
    void add(RayKind kind, const Colour& light) { by_kind[std::size_t(kind)] += light; }
    [[nodiscard]] double mean(RayKind kind) const {
        const Colour& light = by_kind[std::size_t(kind)];
        return (light.x + light.y + light.z) / 3;
    }
};

/// Follows rays through a world. One tracer serves one thread.
template <Numbers N, typename Stage, typename Recorder, typename Order = DepthFirst,
          EffectMask mask = EffectMask::all>
class Tracer {
public:
    using T = ScalarOf<N>;
    static constexpr bool all_effects = mask == EffectMask::all;

    Tracer(const World<N>& world, const Stage& stage, Work<T>& work, Recorder& recorder, Order order = {})
        : world_(world),
          stage_(stage),
          work_(work),
          recorder_(recorder),
          order_(std::move(order)),
          limits_{world.max_depth, world.min_weight} {
        if constexpr (all_effects) adds_ = world.effects == EffectMask::all;
    }

    /// The light that comes back along an eye ray, linear RGB.
    [[nodiscard]] Colour trace(const Ray<T>& ray) { return trace(ray, {RayKind::eye, none, none, none}, 0); }
    /// @param sample of which pixel the ray is which sample
    [[nodiscard]] Colour trace(const Ray<T>& ray, const SampleAddress& sample) {
        const bool needs_seed = all_effects && world_.effects == EffectMask::all;
        return trace(ray, {RayKind::eye, sample.x, sample.y, none}, needs_seed ? sample.seed() : 0);
    }

    [[nodiscard]] const Order& order() const { return order_; }
    /// Depth of the deepest ray of the last trace.
    [[nodiscard]] int deepest() const { return deepest_; }
    /// Of the last trace: the weight of all rays that the limits cut off, per colour.
    [[nodiscard]] const Colour& dropped() const { return dropped_; }
    /// Asks for first_seen() of the traces to come; with all effects alone.
    void keep_first_seen() { adds_ = true; }
    /// Of the last trace, where it was asked for or the scene calls for added effects.
    [[nodiscard]] const FirstSeen& first_seen() const { return seen_; }
    /// Asks for brought() of the traces to come; with all effects alone.
    void keep_brought() { adds_ = keeps_brought_ = true; }
    /// Of the last trace, where it was asked for.
    [[nodiscard]] const BroughtLight& brought() const { return brought_; }

private:
    // What the classic tracer has none of takes no room in it.
    struct Nothing {};
    template <typename X> using Added = std::conditional_t<all_effects, X, Nothing>;

    /// A ray that the material asks for.
    struct Continuation {
        RayKind kind;
        Colour coefficient;
        Vec3<T> direction;
        const Leaving<T>& leaving;
        Id medium;
        double wavelength = 0; ///< nm; 0: its parent's
    };
    /// A ray's bend at a boundary, for one wavelength (nm) or, 0, for all of them.
    struct Bend {
        Refraction<T> bent;
        T speed_from, speed_to;
        double wavelength = 0;

        /// Radians; NaN if there is none.
        [[nodiscard]] double critical_angle() const {
            return rayscope::critical_angle(double(speed_from), double(speed_to)).value_or(not_a_number);
        }
    };
    /// How much of the light at a boundary goes which way.
    struct Shares {
        Colour mirrored, through;
    };
    /// A point that shines: a light, or a sample of its area.
    struct LightPoint {
        Id id;
        int sample, samples;
        Colour colour;
        bool endless; ///< a direction
    };
    /// Of the hashes for a path, the one for lights.
    static constexpr std::uint32_t area_stream = 4;

    [[nodiscard]] Colour trace(const Ray<T>& ray, const RayUse& use, std::uint32_t seed);
    [[nodiscard]] Colour shade(const RayUse& use, const Ray<T>& ray, const Leaving<T>& leaving,
                               const Budget& budget);
    void record_boundary(const Ray<T>& ray, const Interaction<N>& at);

    // Inlined by order: GCC does so by itself where a function is called once, in the classic tracer.
    // With `added` the scene calls for more than the notes' effects; without, nothing of them is asked again.
    template <bool added>
    [[nodiscard, gnu::always_inline]] inline Colour local_light(const Interaction<N>& at,
                                                                const Budget& budget);
    template <bool added>
    [[gnu::always_inline]] inline void add_light_from(Colour& colour, Id light, const Interaction<N>& at,
                                                      const Budget& budget);
    [[nodiscard, gnu::always_inline]] static Vec3<T> to_middle_of(const Light& light,
                                                                  const Interaction<N>& at) {
        const Vec3<T> position = as<T>(light.position);
        return light.directional ? position : position - at.point;
    }
    [[nodiscard, gnu::always_inline]] static Colour highlight(const Vec3<T>& to_light, double cosine,
                                                              const Interaction<N>& at) {
        if (at.wall->specular == Colour{0}) return Colour{0};
        const double mirror = double(mirror_cosine(to_light, at.facing, at.incoming));
        return at.wall->specular * specular_share(cosine, mirror, at.wall->shininess);
    }
    template <bool added>
    [[nodiscard, gnu::always_inline]] inline Colour
    light_along(const LightPoint& light, const Vec3<T>& offset, const Interaction<N>& at,
                const Budget& budget);
    template <bool added>
    [[nodiscard, gnu::always_inline]] inline Colour
    visibility(const LightPoint& light, const Vec3<T>& to_light, T distance, const Interaction<N>& at,
               const Budget& budget);

    [[gnu::always_inline]] inline void add_boundary_light(Colour& colour, const Interaction<N>& at,
                                                          const Budget& budget);
    [[gnu::always_inline]] inline void add_shared_light(Colour& colour, const Interaction<N>& at,
                                                        const Bend& bend, const Shares& shares,
                                                        const Budget& budget);
    [[nodiscard, gnu::always_inline]] inline Refraction<T> bent_at(const Interaction<N>& at, T speed_from,
                                                                   T speed_to) const;
    [[nodiscard]] Colour mirrored_light(const Interaction<N>& at, const Colour& coefficient,
                                        const Budget& budget);
    [[nodiscard]] Colour transmitted_light(const Interaction<N>& at, const Bend& bend,
                                           const Colour& coefficient, const Budget& budget);
    [[nodiscard]] Colour follow(const Continuation& next, const Interaction<N>& at, const Budget& budget);
    [[nodiscard]] Colour follow_waiting();
    void note_total_reflection(const Bend& bend, const Colour& coefficient);
    void refuse(RayKind kind, Reason reason, const Colour& coefficient, const Budget& budget);

    // With all effects alone. Not inlined, lest what is the same for both tracers becomes too large to be.
    [[nodiscard, gnu::noinline]] Colour shade_hit_with_effects(const Ray<T>& ray, Interaction<N> at,
                                                               const Budget& budget, int tested);
    void add_boundary_light_with_effects(Colour& colour, const Interaction<N>& at, const Budget& budget);
    [[gnu::noinline]] void add_area_light(Colour& colour, Id light, const Interaction<N>& at,
                                          const Budget& budget);
    [[nodiscard, gnu::noinline]] Colour passing_with_effects(const Blocker<T>& blocker, const Ray<T>& ray,
                                                             const Leaving<T>& leaving);
    [[nodiscard]] bool spreads(const MediaPair& media) const;
    [[nodiscard]] T speed_at(Id medium, double wavelength) const;
    [[nodiscard, gnu::noinline]] Vec3<T> aside(const LightPoint& point, const Vec3<T>& to_centre,
                                               const Budget& budget) const;
    [[gnu::noinline]] void set_speeds(Interaction<N>& at, double wavelength) const;
    [[nodiscard, gnu::noinline]] EvenMaterials even_materials(const Interaction<N>& at,
                                                              const Ray<T>& ray) const;
    [[nodiscard]] double reflected_share(Mirror mirror, const Bend& bend);
    [[gnu::noinline]] void add_spread_light(Colour& colour, const Interaction<N>& at, const Budget& budget);
    [[nodiscard, gnu::noinline]] Colour absorbed(const Ray<T>& ray, Id medium, T t);
    [[nodiscard, gnu::noinline]] Colour absorbed_to_light(const Ray<T>& ray, T distance,
                                                          const Interaction<N>& at);

    const World<N>& world_;
    const Stage& stage_;
    Work<T>& work_;
    Recorder& recorder_;
    [[no_unique_address]] Order order_;
    RecursionLimits limits_;
    int rays_left_ = 0, deepest_ = 0;
    Colour dropped_{0};
    [[no_unique_address]] Added<bool> adds_{}; // an effect, what is first seen, or who brings light
    [[no_unique_address]] Added<bool> keeps_brought_{};
    [[no_unique_address]] Added<FirstSeen> seen_;
    [[no_unique_address]] Added<BroughtLight> brought_;
    [[no_unique_address]] Added<RayKind> kind_{}; // of the ray that is shaded, until it spawns others
    [[no_unique_address]] Added<Spectrum> spectrum_;
};

} // namespace rayscope

#include "core/tracer/added_effects.inl"
#include "core/tracer/lights.inl"
#include "core/tracer/shade.inl"
