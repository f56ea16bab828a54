#pragma once
// The first stage: every ray against every object. What all later stages must agree with, bit for bit.

#include "core/stage/balls.hpp"
#include "core/stage/search.hpp"

namespace rayscope {

template <Numbers N> class Scan : public StageBase<N, Scan<N>> {
public:
    using T = ScalarOf<N>;

    explicit Scan(const World<N>& world);

    [[nodiscard]] static constexpr bool tests_parts(const RayUse& /*use*/) { return false; }
    template <typename Search> [[gnu::noinline]] void look(const RayUse&, Search& search) const;

private:
    Balls<N> balls_;
    std::size_t ball_count_ = 0;
    std::vector<std::uint32_t> others_; // objects that no ball decides on, in the order of the file
    std::vector<std::uint32_t>
        not_balls_; // with the compounds that one decides on: a recorded ray tells of them too
};

template <Numbers N> Scan<N>::Scan(const World<N>& world) : StageBase<N, Scan<N>>(world) {
    for (std::uint32_t id = 0; id < world.objects.size(); ++id) {
        const Object& object = world.objects[id];
        if (!world.is_ball(object)) not_balls_.push_back(id);
        if (const auto ball = deciding_ball(world, object)) {
            balls_.add(world.solids[*ball], id);
            ++ball_count_;
        } else {
            others_.push_back(id);
        }
    }
    balls_.pad();
}

template <Numbers N>
template <typename Search>
void Scan<N>::look(const RayUse& /*use*/, Search& search) const {
    constexpr bool recording = Search::recording;
    std::size_t met = 0, later = recording ? not_balls_.size() - others_.size() : 0;
    const std::size_t end = balls_.each_met(search.ray(), 0, balls_.size(), [&](std::uint32_t object) {
        ++met; // counted by its test
        if (recording && this->world_.objects[object].is_compound) {
            --later;
            return false; // its turn comes below
        }
        return search.test(object);
    });
    const std::size_t tested = std::min(end, ball_count_);
    const std::size_t unmet = tested - met - std::min(tested - met, later);
    search.work().counters.objects += unmet;
    search.work().counters.tests[generic_index<N, Sphere<N>>()] += unmet;
    if (search.done()) return;
    for (const std::uint32_t object : recording ? not_balls_ : others_)
        if (search.test(object)) return;
}

} // namespace rayscope
