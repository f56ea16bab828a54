#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<Textbook<long double>>&, const Camera&, const RenderOptions&);
template Recording record(const World<Textbook<long double>>&, const Ray<double>&);
template std::vector<FirstHit> first_hits(const World<Textbook<long double>>&, const Camera&,
                                          const RenderOptions&);

} // namespace rayscope
