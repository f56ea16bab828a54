// Too long to be inlined, so compiled here alone: no caller brings a copy of its own, with whatever options it has.

#include "core/refraction/snell.hpp"

namespace rayscope {

template Refraction<float> refract<float>(Vec3<float>, Vec3<float>, float, float);
template Refraction<double> refract<double>(Vec3<double>, Vec3<double>, double, double);
template Refraction<long double> refract<long double>(Vec3<long double>, Vec3<long double>, long double,
                                                      long double);
template Refraction<Float128> refract<Float128>(Vec3<Float128>, Vec3<Float128>, Float128, Float128);
template Refraction<float> refract<Textbook<float>>(Vec3<float>, Vec3<float>, float, float);
template Refraction<double> refract<Textbook<double>>(Vec3<double>, Vec3<double>, double, double);
template Refraction<long double> refract<Textbook<long double>>(Vec3<long double>, Vec3<long double>,
                                                                long double, long double);
template Refraction<Float128> refract<Textbook<Float128>>(Vec3<Float128>, Vec3<Float128>, Float128, Float128);

} // namespace rayscope
