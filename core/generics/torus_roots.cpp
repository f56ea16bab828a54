// Too long to be inlined, so compiled here alone: no caller brings a copy of its own, with whatever options it has.

#include "core/generics/torus_roots.hpp"

#include "core/generics/torus_textbook.hpp"

namespace rayscope {

template TorusRoots<float> torus_roots(float, const Ray<float>&);
template TorusRoots<double> torus_roots(double, const Ray<double>&);
template TorusRoots<long double> torus_roots(long double, const Ray<long double>&);
template TorusRoots<Float128> torus_roots(Float128, const Ray<Float128>&);

template Intervals<float> torus_textbook(float, const Ray<float>&);
template Intervals<double> torus_textbook(double, const Ray<double>&);
template Intervals<long double> torus_textbook(long double, const Ray<long double>&);
template Intervals<Float128> torus_textbook(Float128, const Ray<Float128>&);

} // namespace rayscope
