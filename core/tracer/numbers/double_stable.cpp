#include "core/tracer/object_spans.inl"
#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render(const World<double>&, const Camera&, const RenderOptions&);
template Recording record(const World<double>&, const Ray<double>&, const std::optional<SampleAddress>&);
template std::vector<ObjectSpan> object_spans(const World<double>&, std::uint32_t, const Ray<double>&);
template std::vector<FirstHit> first_hits(const World<double>&, const Camera&, const RenderOptions&);
template std::vector<ReferenceSample> reference_samples(const World<double>&, const EyeRays&, int, int, int,
                                                        const RenderOptions&);

Recording record(const World<double>& world, const StageSet& stages, const Ray<double>& ray,
                 const std::optional<SampleAddress>& sample) {
    return recorded_by(world, stages, ray, sample);
}

} // namespace rayscope
