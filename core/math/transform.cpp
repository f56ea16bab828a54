#include "core/math/transform.hpp"

#include <array>

namespace rayscope {
namespace {

using Wide = __float128;
using Rows = std::array<std::array<Wide, 3>, 3>;

template <Scalar T> Rows linear_part(const Mat4<T>& matrix) {
    Rows rows{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[std::size_t(i)][std::size_t(j)] = Wide(matrix[j][i]);
    return rows;
}

// Cofactors in 113 bits: even a matrix with condition 10¹² keeps more digits than a double can hold.
Rows cofactors(const Rows& m) {
    Rows c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
            c[i][j] = m[p][r] * m[q][s] - m[p][s] * m[q][r];
        }
    return c;
}

Wide determinant(const Rows& m, const Rows& c) {
    return m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
}

} // namespace

template <Scalar T> Transform<T>::Transform(const Mat4<T>& matrix) {
    const Rows m = linear_part(matrix);
    const Rows c = cofactors(m);
    const Wide det = determinant(m, c);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse_[i][j] = T(c[std::size_t(j)][std::size_t(i)] / det);
    translation_ = {matrix[3][0], matrix[3][1], matrix[3][2]};
}

bool is_invertible(const Mat4d& matrix) {
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i)
            if (!std::isfinite(matrix[j][i])) return false;
    const Rows m = linear_part(matrix);
    const Rows c = cofactors(m);
    const Wide det = determinant(m, c);
    if (det == 0) return false;
    for (const auto& row : c)
        for (const Wide cofactor : row)
            if (!std::isfinite(double(cofactor / det))) return false;
    return true;
}

double similarity_scale(const Mat4d& matrix) {
    const auto column = [&](int j) { return Vec3d{matrix[j][0], matrix[j][1], matrix[j][2]}; };
    const double scale = length(column(0));
    const double slack = 2 * epsilon<double> * scale; // a rotation matrix is itself rounded
    for (int j = 1; j < 3; ++j)
        if (std::abs(length(column(j)) - scale) > slack) return 0;
    for (int j = 0; j < 3; ++j)
        if (std::abs(dot(column(j), column((j + 1) % 3)) / scale) > slack) return 0;
    return scale;
}

template class Transform<double>;

} // namespace rayscope
