#include "core/math/scalar.hpp"

// The C library has these; its header shows them to GCC alone.
extern "C" {
__float128 sqrtf128(__float128) noexcept;
__float128 cbrtf128(__float128) noexcept;
__float128 cosf128(__float128) noexcept;
__float128 acosf128(__float128) noexcept;
__float128 strtof128(const char*, char**) noexcept;
}

namespace rayscope {

Float128 sqrt(Float128 a) { return sqrtf128(a); }
Float128 cbrt(Float128 a) { return cbrtf128(a); }
Float128 cos(Float128 a) { return cosf128(a); }
Float128 acos(Float128 a) { return acosf128(a); }

Float128 float128_from(const std::string& decimal) { return strtof128(decimal.c_str(), nullptr); }

} // namespace rayscope
