#include "core/tracer/object_spans.inl"
#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<float>&, const Camera&, const RenderOptions&);
template Recording record(const World<float>&, const Ray<double>&, const std::optional<SampleAddress>&);
template std::vector<ObjectSpan> object_spans(const World<float>&, std::uint32_t, const Ray<float>&);
template std::vector<FirstHit> first_hits(const World<float>&, const Camera&, const RenderOptions&);

} // namespace rayscope
