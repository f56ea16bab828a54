#include "core/tracer/render.inl"

namespace rayscope {

template RenderResult render_with<double, EffectMask::all>(const World<double>&, const Camera&,
                                                           const RenderOptions&);

} // namespace rayscope
