#include "core/math/transform.hpp"

#include "core/math/substituted.hpp"
#include <array>

namespace rayscope {
namespace {

template <Scalar T> using Rows = std::array<std::array<T, 3>, 3>;

template <Scalar T> Rows<T> linear_part(const Mat4d& matrix) {
    Rows<T> rows{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[std::size_t(i)][std::size_t(j)] = T(matrix[j][i]);
    return rows;
}

// @tparam of_doubles the numbers are doubles in a wider type: there a product of two is exact
template <bool of_doubles = false, Scalar T> Rows<T> cofactors(const Rows<T>& m) {
    Rows<T> c{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::size_t p = (i + 1) % 3, q = (i + 2) % 3, r = (j + 1) % 3, s = (j + 2) % 3;
            if constexpr (of_doubles && std::is_same_v<T, Float128>)
                c[i][j] = m[p][r] * m[q][s] - m[p][s] * m[q][r];
            else
                c[i][j] = difference_of_products(m[p][r], m[q][s], m[p][s], m[q][r]);
        }
    return c;
}

template <Scalar T> T determinant(const Rows<T>& m, const Rows<T>& c) {
    return m[0][0] * c[0][0] + m[0][1] * c[0][1] + m[0][2] * c[0][2];
}

// In 113 bits even a matrix with condition 10¹² keeps more digits than a double can hold.
template <Numbers N> using Working = std::conditional_t<is_textbook<N>, ScalarOf<N>, Float128>;

// In doubles, a fiftieth of the work: the determinant is far from what rounding can make of 0, and no element of the
// inverse can exceed 2 · 10⁶ / largest.
bool is_clearly_invertible(const Mat4d& matrix) {
    const auto m = linear_part<double>(matrix);
    double largest = 0;
    for (const auto& row : m)
        for (const double element : row) largest = maximum(largest, magnitude(element));
    if (!(largest > 1e-100 && largest < 1e100)) return false;
    return magnitude(determinant(m, cofactors(m))) > 1e-6 * largest * largest * largest;
}

} // namespace

template <Numbers N> Transform<N>::Transform(const Mat4d& matrix) {
    if (Mat3<double>(matrix) == Mat3<double>(1)) {
        *this = moving(Vec3d(matrix[3]));
        return;
    }
    const auto m = linear_part<Working<N>>(matrix);
    const auto c = cofactors<true>(m);
    const auto det = determinant(m, c);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) inverse_[i][j] = T(c[std::size_t(j)][std::size_t(i)] / det);
    translation_ = {T(matrix[3][0]), T(matrix[3][1]), T(matrix[3][2])};
    only_moves_ = inverse_ == Mat3<T>{T(1)};
    if constexpr (is_textbook<N>) column_ = -apply(translation_);
}

template <Numbers N> auto Transform<N>::matrix() const -> Mat4<T> {
    Rows<T> rows{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) rows[std::size_t(i)][std::size_t(j)] = inverse_[i][j];
    const auto c = cofactors(rows);
    const T det = determinant(rows, c);
    Mat4<T> matrix{T(1)};
    for (int i = 0; i < 3; ++i) // row i of the cofactors, over the determinant, is column i of M
        for (int j = 0; j < 3; ++j) matrix[i][j] = c[std::size_t(i)][std::size_t(j)] / det;
    for (int j = 0; j < 3; ++j) matrix[3][j] = translation_[j];
    return matrix;
}

template <Numbers N> auto Transform<N>::distortion() const -> T {
    const Mat4<T> m = matrix();
    T sum = T(0);
    for (int i = 0; i < 3; ++i)
        sum += length(Vec3<T>{m[i][0], m[i][1], m[i][2]}) * length(Vec3<T>(inverse_[i]));
    return sum;
}

bool is_invertible(const Mat4d& matrix) {
    for (int j = 0; j < 4; ++j)
        for (int i = 0; i < 3; ++i)
            if (!is_finite(matrix[j][i])) return false;
    if (is_clearly_invertible(matrix)) return true;
    const auto m = linear_part<Float128>(matrix);
    const auto c = cofactors<true>(m);
    const Float128 det = determinant(m, c);
    if (det == 0) return false;
    for (const auto& row : c)
        for (const Float128 cofactor : row)
            if (!is_finite(double(cofactor / det))) return false;
    return true;
}

template <Scalar T> T similarity_scale(const Mat4d& matrix) {
    const auto column = [&](int j) { return as<T>(Vec3d{matrix[j][0], matrix[j][1], matrix[j][2]}); };
    const T scale = length(column(0));
    const T slack = T(2) * epsilon<T> * scale; // a rotation matrix is itself rounded
    for (int j = 1; j < 3; ++j)
        if (magnitude(length(column(j)) - scale) > slack) return T(0);
    for (int j = 0; j < 3; ++j)
        if (magnitude(dot(column(j), column((j + 1) % 3)) / scale) > slack) return T(0);
    return scale;
}

template float similarity_scale(const Mat4d&);
template double similarity_scale(const Mat4d&);
template long double similarity_scale(const Mat4d&);
template Float128 similarity_scale(const Mat4d&);

template class Transform<float>;
template class Transform<double>;
template class Transform<long double>;
template class Transform<Float128>;
template class Transform<Textbook<float>>;
template class Transform<Textbook<double>>;
template class Transform<Textbook<long double>>;
template class Transform<Textbook<Float128>>;
template class Transform<Substituted>;

} // namespace rayscope
