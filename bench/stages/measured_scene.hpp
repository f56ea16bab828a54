#pragma once
// A scene, and what each stage took for each kind of ray in it.

#include "bench/support/ray_sets.hpp"
#include "core/rayscope.hpp"
#include "core/tracer/stage_set.hpp"

#include <memory>
#include <optional>

namespace rayscope::bench {

struct StageScene {
    std::string name;
    bool is_cloud = false; ///< one of a family that differs in its number of objects alone
    Workbench workbench;
};

enum class Rays { eye, shadow, other };
inline constexpr std::array<const char*, 3> rays_names{"eye", "shadow", "other"};

/// One row of the table: a stage that served one kind of ray.
struct StageRun {
    std::string scene, stage;
    Rays rays = Rays::eye;
    bool is_cloud = false;
    std::size_t objects = 0;
    double tests = 0, cells = 0; ///< per ray; inner nodes count as cells
    double build_seconds = 0;
    std::size_t bytes = 0;  ///< 0: not known
    double nanoseconds = 0; ///< per ray
    std::string benchmark;  ///< under which its times stand

    [[nodiscard]] std::string title() const {
        return scene + '/' + stage + '/' + rays_names[std::size_t(rays)];
    }
};

/// The scenes whose names begin so; all where the list is empty. Clouds have up to `most` balls.
[[nodiscard]] std::vector<std::shared_ptr<const StageScene>>
stage_scenes(const std::vector<std::string>& names, std::size_t most);

/// Compares the images of all stages, and the answers for all rays; then registers the benchmarks. Nothing if two
/// differ, which is said.
[[nodiscard]] std::optional<std::vector<StageRun>>
register_stages(const std::shared_ptr<const StageScene>& scene);

} // namespace rayscope::bench
