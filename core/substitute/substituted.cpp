#include "core/substitute/substituted.hpp"

#include "core/scene/build.hpp"
#include "core/substitute/hooks.hpp"
#include "core/tracer/object_spans.inl"
#include "core/tracer/render.inl"

#include <mutex>

namespace rayscope {
namespace {

/// The formulas are in use as long as it lives; who comes later waits.
class Use {
public:
    explicit Use(const Formulas& formulas) : lock_(guard_) { formulas_in_use().formulas = &formulas; }

private:
    static inline std::mutex guard_;
    std::lock_guard<std::mutex> lock_;
};

} // namespace

RenderResult render_with(const Scene& scene, const Formulas& formulas, RenderOptions options) {
    const Use use(formulas);
    options.threads = 1;
    return render(build<Substituted>(scene), scene.camera, options);
}

Recording record_with(const Scene& scene, const Formulas& formulas, const Ray<double>& ray) {
    const Use use(formulas);
    return record(build<Substituted>(scene), ray);
}

} // namespace rayscope
