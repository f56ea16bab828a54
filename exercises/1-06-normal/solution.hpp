#include "rx.hpp"
using namespace rx;

dvec3 worldNormal(const dvec3& n, const dmat4& M) {
    return glm::normalize(glm::transpose(glm::inverse(dmat3(M))) * n);
}
