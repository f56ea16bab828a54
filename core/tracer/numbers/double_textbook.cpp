#include "core/tracer/object_spans.inl"
#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<Textbook<double>>&, const Camera&, const RenderOptions&);
template Recording record(const World<Textbook<double>>&, const Ray<double>&,
                          const std::optional<SampleAddress>&);
template std::vector<ObjectSpan> object_spans(const World<Textbook<double>>&, std::uint32_t,
                                              const Ray<double>&);
template std::vector<FirstHit> first_hits(const World<Textbook<double>>&, const Camera&,
                                          const RenderOptions&);

} // namespace rayscope
