#include "rx.hpp"
using namespace rx;

Ray toObject(const Ray& r, const dmat4& M) {
    const dmat4 inverse = glm::inverse(M);
    return {dvec3(inverse * dvec4(r.o, 1)), dvec3(inverse * dvec4(r.d, 0))};
}
