#pragma once
// The recursion.

#include "core/reflection/mirror.hpp"
#include "core/refraction/snell.hpp"
#include "core/shading/phong.hpp"
#include "core/stage/ray_use.hpp"
#include "core/tracer/budget.hpp"
#include "core/tracer/interaction.hpp"
#include "core/tracer/order.hpp"
#include "core/tracer/recording.hpp"

namespace rayscope {

/// Follows rays through a world. One tracer serves one thread.
template <Numbers N, typename Stage, typename Recorder, typename Order = DepthFirst> class Tracer {
public:
    using T = ScalarOf<N>;

    Tracer(const World<N>& world, const Stage& stage, Work<T>& work, Recorder& recorder, Order order = {})
        : world_(world),
          stage_(stage),
          work_(work),
          recorder_(recorder),
          order_(std::move(order)),
          limits_{world.max_depth, world.min_weight} {}

    /// The light that comes back along an eye ray, linear RGB.
    /// @param x, y the pixel that it goes through, if any
    [[nodiscard]] Colour trace(const Ray<T>& ray, int x = none, int y = none);

    [[nodiscard]] const Order& order() const { return order_; }
    /// Depth of the deepest ray of the last trace.
    [[nodiscard]] int deepest() const { return deepest_; }

private:
    /// A ray that the material asks for.
    struct Continuation {
        RayKind kind;
        Colour coefficient;
        Vec3<T> direction;
        const Leaving<T>& leaving;
        Id medium;
    };

    [[nodiscard]] Colour shade(const RayUse& use, const Ray<T>& ray, const Leaving<T>& leaving,
                               const Budget& budget);
    [[nodiscard]] Colour local_light(const Interaction<N>& at, const Budget& budget);
    [[nodiscard]] Colour light_from(Id light, const Interaction<N>& at, const Budget& budget);
    [[nodiscard]] Colour visibility(Id light, const Vec3<T>& to_light, T distance, const Interaction<N>& at,
                                    const Budget& budget);
    [[nodiscard]] Colour mirrored_light(const Interaction<N>& at, const Colour& coefficient,
                                        const Budget& budget);
    [[nodiscard]] Colour transmitted_light(const Interaction<N>& at, const Refraction<T>& bent,
                                           const Budget& budget);
    [[nodiscard]] Colour follow(const Continuation& next, const Interaction<N>& at, const Budget& budget);
    [[nodiscard]] Colour follow_waiting();
    void note_total_reflection(const Refraction<T>& bent, const Colour& coefficient,
                               const Interaction<N>& at);
    void refuse(RayKind kind, Reason reason, const Colour& coefficient, const Budget& budget);

    const World<N>& world_;
    const Stage& stage_;
    Work<T>& work_;
    Recorder& recorder_;
    [[no_unique_address]] Order order_;
    RecursionLimits limits_;
    RayUse eye_;
    int rays_left_ = 0, deepest_ = 0;
};

} // namespace rayscope

#include "core/tracer/shade.inl"
