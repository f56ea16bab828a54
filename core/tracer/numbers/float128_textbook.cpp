#include "core/tracer/object_spans.inl"
#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<Textbook<Float128>>&, const Camera&, const RenderOptions&);
template Recording record(const World<Textbook<Float128>>&, const Ray<double>&,
                          const std::optional<SampleAddress>&);
template std::vector<ObjectSpan> object_spans(const World<Textbook<Float128>>&, std::uint32_t,
                                              const Ray<Float128>&);
template std::vector<FirstHit> first_hits(const World<Textbook<Float128>>&, const Camera&,
                                          const RenderOptions&);

} // namespace rayscope
