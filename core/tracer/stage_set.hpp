#pragma once
// The stages of one world, each for the rays that it is best at.

#include "core/bvh/bvh.hpp"
#include "core/extents/extents.hpp"
#include "core/extents/light_extents.hpp"
#include "core/extents/projective_extents.hpp"
#include "core/extents/scan.hpp"
#include "core/octree/octree.hpp"
#include "core/stage/record_search.hpp"
#include "core/stage/stage_choice.hpp"

#include <memory>

namespace rayscope {

/// The screen that projective extents are made for.
struct Screen {
    EyeRays eye_rays;
    int width, height;
};

/// Only what the choice asks for is built. Eye rays of no pixel go the way of all others.
class StageSet : public StageBase<double, StageSet> {
public:
    StageSet(const World<double>& world, const StageChoice& choice, const std::optional<Screen>& screen);

    [[nodiscard]] bool tests_parts(const RayUse& use) const { return kind_for(use) != StageKind::scan; }
    template <typename Search> void look(const RayUse& use, Search& search) const {
        if constexpr (Search::recording) {
            const std::size_t objects = world_.objects.size();
            search.recorder().record(SearchBegan{kind_for(use), int(objects)});
            look_by(kind_for(use), use, search);
            search.recorder().record(search_ended(search.end(), double(search.reach()), search.before(),
                                                  search.work().counters, objects));
        } else {
            look_by(kind_for(use), use, search);
        }
    }

    [[nodiscard]] const StageChoice& choice() const { return choice_; }
    [[nodiscard]] double build_seconds() const { return build_seconds_; }
    [[nodiscard]] const Octree<double>* octree() const { return octree_.get(); }
    [[nodiscard]] const Bvh<double>* bvh() const { return bvh_.get(); }
    [[nodiscard]] const ProjectiveExtents<double>* projective() const { return projective_.get(); }
    [[nodiscard]] const LightExtents<double>* light() const { return light_.get(); }

private:
    template <typename Search> void look_by(StageKind kind, const RayUse& use, Search& search) const {
        switch (kind) {
        case StageKind::scan: scan_->look(use, search); break;
        case StageKind::extents: extents_->look(use, search); break;
        case StageKind::projective: projective_->look(use, search); break;
        case StageKind::light: light_->look(use, search); break;
        case StageKind::octree: octree_->look(use, search); break;
        case StageKind::bvh: bvh_->look(use, search); break;
        }
    }
    // Lists are kept for points: rays to an area go the way of all others.
    [[nodiscard]] StageKind kind_for(const RayUse& use) const {
        if (use.kind == RayKind::shadow)
            return choice_.shadow == StageKind::light && use.light == none ? choice_.other : choice_.shadow;
        if (use.kind != RayKind::eye) return choice_.other;
        if (choice_.eye == StageKind::projective && !projective_->knows(use)) return choice_.other;
        return choice_.eye;
    }
    void build(StageKind kind, const std::optional<Screen>& screen);

    StageChoice choice_;
    double build_seconds_ = 0;
    std::unique_ptr<Scan<double>> scan_;
    std::unique_ptr<Extents<double>> extents_;
    std::unique_ptr<ProjectiveExtents<double>> projective_;
    std::unique_ptr<LightExtents<double>> light_;
    std::unique_ptr<Octree<double>> octree_;
    std::unique_ptr<Bvh<double>> bvh_;
};

/// The quickest choice for a world, and why, in a sentence.
struct BestChoice {
    StageChoice choice;
    std::string reason;
};
[[nodiscard]] BestChoice best_choice(const World<double>& world);

} // namespace rayscope
