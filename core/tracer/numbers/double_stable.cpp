#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<double>&, const Camera&, const RenderOptions&);
template Recording record(const World<double>&, const Ray<double>&);

} // namespace rayscope
