#pragma once
// The schoolbook's way to a solid's inside list: hits, each found on its own, are sorted and taken in pairs.

#include "core/generics/spans.hpp"

namespace rayscope {

/// Hits of one line with the faces of a convex solid. At a rim two faces may both claim a hit or both disown it; then
/// the count is odd and the parity of all that follows is wrong. Intersecting intervals (see Cylinder) can't go wrong so.
template <Scalar T> class PairedHits {
public:
    void add(T t, int face) {
        if (!is_finite(t) || count_ == int(items_.size())) return;
        int place = count_++;
        for (; place > 0 && t < items_[std::size_t(place) - 1].t; --place)
            items_[std::size_t(place)] = items_[std::size_t(place) - 1];
        items_[std::size_t(place)] = {t, face};
    }

    [[nodiscard]] Intervals<T> intervals() const {
        Intervals<T> found;
        for (int i = 0; i < count_; i += 2) {
            const Hit& in = items_[std::size_t(i)];
            const Hit out = i + 1 < count_ ? items_[std::size_t(i) + 1] : Hit{infinity<T>, in.face};
            if (in.t < out.t) found.append({in.t, out.t, in.face, out.face});
        }
        return found;
    }

private:
    struct Hit {
        T t;
        int face;
    };
    std::array<Hit, 4> items_;
    int count_ = 0;
};

} // namespace rayscope
