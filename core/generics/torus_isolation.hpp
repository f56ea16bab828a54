#pragma once
// The torus's crossings for every line, however it grazes: isolated one by one, then polished.

#include "core/generics/torus_line.hpp"

namespace rayscope {

/// Ends, ascending, of pieces on which the quartic (s² + bs + k)² − 4(As² + Bs + C) is monotone: it turns where its
/// derivative, a cubic, changes sign. The last one is part.exit.
template <Scalar T>
[[nodiscard]] int monotone_pieces(const TorusLine<T>& line, const Interval<T>& part, std::array<T, 5>& ends) {
    const Vec3<T>&q = line.q, &e = line.e;
    const T k = fma(T(1) - line.minor, T(1) + line.minor, dot(q, q));
    const T b = T(2) * dot(q, e);
    const T A = fma(e.x, e.x, e.y * e.y), B = T(2) * fma(q.x, e.x, q.y * e.y);
    const std::array<T, 4> derivative{T(2) * b * k - T(4) * B, T(2) * (b * b + T(2) * k - T(4) * A), T(6) * b,
                                      T(4)};
    const CubicRoots<T> turns = cubic_sign_changes(derivative, part.enter, part.exit);
    for (int i = 0; i < turns.count; ++i) ends[std::size_t(i)] = turns.items[std::size_t(i)];
    ends[std::size_t(turns.count)] = part.exit;
    return turns.count + 1;
}

/// Between two turns lies at most one crossing, and whether it does is asked of the distance, which does not cancel.
/// No formula for quartic roots: Ferrari's loses double ones.
template <Scalar T>
[[nodiscard, gnu::noinline, gnu::cold]] TorusRoots<T> isolated_roots(const TorusLine<T>& line,
                                                                     const Interval<T>& part) {
    if (part.empty()) return {};
    std::array<T, 5> ends{};
    const int pieces = monotone_pieces(line, part, ends);
    TorusRoots<T> roots;
    T from = part.enter;
    bool inside = line.distance(from).value < T(0);
    for (int i = 0; i < pieces; ++i) {
        const T to = ends[std::size_t(i)];
        const bool inside_at_end = line.distance(to).value < T(0);
        if (inside != inside_at_end)
            roots.add(bracketed_root([&](T s) { return line.distance(s); }, from, to, inside, epsilon<T>,
                                     from + (to - from) / T(2)));
        from = to;
        inside = inside_at_end;
    }
    return roots;
}

} // namespace rayscope
