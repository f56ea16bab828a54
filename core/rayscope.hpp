#pragma once
// The public face of rayscope: load a scene, render it, trace one ray with everything that it does, ask for spans.
//
//     const Workbench bench = open("chapters/02_csg/glass_bowl.toml");
//     const Trace trace = trace_pixel(bench, 256, 200);
//     write_trace(trace, "bowl.json");

#include "core/accuracy/configuration.hpp"
#include "core/accuracy/report.hpp"
#include "core/accuracy/verdict.hpp"
#include "core/cases/score_report.hpp"
#include "core/effects/change_effects.hpp"
#include "core/effects/effect_cost.hpp"
#include "core/extents/light_view.hpp"
#include "core/files/atomic_file.hpp"
#include "core/files/markup.hpp"
#include "core/files/temporary_folder.hpp"
#include "core/files/utf8.hpp"
#include "core/image/image.hpp"
#include "core/image/map.hpp"
#include "core/image/srgb.hpp"
#include "core/octree/why_not_cell.hpp"
#include "core/povray/export.hpp"
#include "core/scene/expand.hpp"
#include "core/scene/name_trace.hpp"
#include "core/scene/scene.hpp"
#include "core/scene/wording.hpp"
#include "core/shading/phong.hpp"
#include "core/shading/spectrum.hpp"
#include "core/substitute/formulas.hpp"
#include "core/trace/children.hpp"
#include "core/trace/divergence.hpp"
#include "core/trace/ledger.hpp"
#include "core/trace/trace.hpp"
#include "core/trace/trace_json.hpp"
#include "core/tracer/render.hpp"
#include "core/tracer/why_not.hpp"
#include "core/walk/find.hpp"
#include "core/walk/passing.hpp"
#include "core/walk/quiz.hpp"
#include "core/walk/refraction_card.hpp"
#include "core/walk/walk.hpp"
#include "core/walk/walk_json.hpp"

#include <filesystem>
#include <memory>

namespace rayscope {

/// A scene and the world that the rays see. Movable, not copyable.
struct Workbench {
    Scene scene;
    World<double> world;
};

/// Reads .toml, .nff, or a mesh, .obj or .ply, by extension. Throws InputError.
/// @param effects what a person asks for, as parse_effects reads it; it overrides the scene's own word. Throws
/// std::invalid_argument where it can't be read. A warning says what the scene would not have called for.
[[nodiscard]] Scene load_scene(const std::filesystem::path& path,
                               const std::optional<std::string>& effects = {});
[[nodiscard]] Workbench open(const std::filesystem::path& path,
                             const std::optional<std::string>& effects = {});

/// From a scene that is at hand. Throws InputError where it can't be drawn.
[[nodiscard]] Workbench make_workbench(Scene scene);

/// The same bytes for any number of threads.
[[nodiscard]] RenderResult render(const Workbench& bench, const RenderOptions& options = {});

/// The scene in the numbers and with the limits of a configuration, ready to be rendered; the scene itself is not
/// needed any more.
[[nodiscard]] std::function<RenderResult(const RenderOptions&)> renderer(const Scene& scene,
                                                                         const Configuration& configuration);

/// The scene's own configuration: double, stable, and its limits.
[[nodiscard]] Configuration own_configuration(const Scene& scene);

/// 16 hexadecimal digits that change with the file's bytes. Throws InputError where it can't be read.
[[nodiscard]] std::string content_hash(const std::filesystem::path& path);
/// … and with the meshes that the scene in it takes from other files.
[[nodiscard]] std::string content_hash(const std::filesystem::path& path, const Scene& scene);

/// The sample of pixel (x, y), traced again with everything recorded: its colour is the image's, bit for bit.
/// width × height: of the image that the pixel belongs to; 0: the scene's.
/// sample: which of the pixel's, 0 in its middle
[[nodiscard]] Trace trace_pixel(const Workbench& bench, int x, int y, int width = 0, int height = 0,
                                int sample = 0);

/// A ray given by hand. Its direction need not be unit.
[[nodiscard]] Trace trace_ray(const Workbench& bench, const Ray<double>& ray);

/// By formulas that stand in place of ours. Both throw what the formulas throw.
[[nodiscard]] RenderResult render(const Workbench& bench, const Formulas& formulas,
                                  const RenderOptions& options = {});
[[nodiscard]] Trace trace_pixel(const Workbench& bench, const Formulas& formulas, int x, int y, int width = 0,
                                int height = 0);
[[nodiscard]] Trace trace_ray(const Workbench& bench, const Formulas& formulas, const Ray<double>& ray);

/// What finds the hits of a workbench's rays: built once, asked by many. The workbench must outlive it.
/// @param choice none: the quickest for the scene
/// @param width, height of the image that pixels belong to; 0: the scene's
[[nodiscard]] std::shared_ptr<const StageSet>
make_stages(const Workbench& bench, const std::optional<StageChoice>& choice, int width = 0, int height = 0);
/// Of the octree among the stages; nothing if there is none.
[[nodiscard]] std::optional<OctreeStatistics> octree_statistics(const StageSet& stages);

/// The same rays, hits and colours by the way of stages: the trace tells of the places that they look into, and only of
/// the objects that they test.
[[nodiscard]] Trace trace_pixel(const Workbench& bench, const StageSet& stages, int x, int y, int width = 0,
                                int height = 0, int sample = 0);
[[nodiscard]] Trace trace_ray(const Workbench& bench, const StageSet& stages, const Ray<double>& ray);

/// The same rays in the numbers and with the limits of a configuration; what is recorded is double all the same.
[[nodiscard]] Trace trace_pixel(const Workbench& bench, const Configuration& configuration, int x, int y,
                                int width = 0, int height = 0, int sample = 0);
[[nodiscard]] Trace trace_ray(const Workbench& bench, const Configuration& configuration,
                              const Ray<double>& ray);

/// Where the light of an image comes from, every sample of it recorded: mean light and mean dropped weight of a pixel.
/// Objects are the scene's drawn ones.
/// @param width, height 0: the scene's
/// @param stop set to true from outside: it ends soon, and what it tells means nothing
[[nodiscard]] Ledger ledger(const Workbench& bench, int width = 0, int height = 0,
                            const std::atomic<bool>* stop = nullptr);

/// The screen as the stage of projective extents sees it.
struct ScreenExtents {
    struct Rectangle {
        std::string name;                                ///< of the drawn object
        double left = 0, top = 0, right = 0, bottom = 0; ///< pixels, cut to the screen
        double nearest = 0;                              ///< the object's least distance from the eye
    };
    std::vector<Rectangle> rectangles; ///< nearest first
    std::vector<std::string> apart;    ///< objects without a rectangle: in no list
    int width = 0, height = 0;
    int tile = 0; ///< pixels along an edge
    Map entries;  ///< of each tile: the objects in its list
};
/// @param width, height of the image; 0: the scene's
[[nodiscard]] ScreenExtents screen_extents(const Workbench& bench, int width = 0, int height = 0);

/// The windows through which the stage of light extents looks from a light (an index into Scene::lights).
[[nodiscard]] std::vector<LightWindow> light_windows(const Workbench& bench, std::size_t light);

/// Why ray number `ray` of a trace of this workbench did not end on a drawn object (an index into Scene::drawn).
[[nodiscard]] WhyNot why_not(const Workbench& bench, const Trace& trace, std::size_t ray, std::size_t object);

/// Why ray number `ray` did not look into a cell of the octree; nothing if `stages` have no octree, or it no such cell.
[[nodiscard]] std::optional<WhyNotCell> why_not_cell(const StageSet& stages, const Trace& trace,
                                                     std::size_t ray, std::uint32_t cell);

/// The inside list of each object on a ray's whole line.
[[nodiscard]] std::vector<Spans<double>> spans(const Workbench& bench, const Ray<double>& ray);

/// By extension: .json. Complete or not at all.
void write_trace(const Trace& trace, const std::filesystem::path& path);

} // namespace rayscope
