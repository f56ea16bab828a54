#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<Textbook<Float128>>&, const Camera&, const RenderOptions&);
template Recording record(const World<Textbook<Float128>>&, const Ray<double>&);

} // namespace rayscope
