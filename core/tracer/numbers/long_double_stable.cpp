#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<long double>&, const Camera&, const RenderOptions&);
template Recording record(const World<long double>&, const Ray<double>&);
template std::vector<FirstHit> first_hits(const World<long double>&, const Camera&, const RenderOptions&);

} // namespace rayscope
