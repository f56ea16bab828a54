#pragma once
// Shapes of one kind in groups of eight, each group's numbers side by side in memory: what a tree tests in a leaf.

#include "core/math/ray.hpp"
#include "core/math/vec.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

namespace rayscope {

/// What all tests of one ray share.
template <Scalar T> struct GroupRay {
    T x, y, z, dx, dy, dz, dd, inverse_dd, inverse_length;

    explicit GroupRay(const Ray<T>& ray)
        : x(ray.origin.x),
          y(ray.origin.y),
          z(ray.origin.z),
          dx(ray.direction.x),
          dy(ray.direction.y),
          dz(ray.direction.z),
          dd(dot(ray.direction, ray.direction)),
          inverse_dd(T(1) / dd),
          inverse_length(T(1) / sqrt(dd)) {}
};

constexpr std::size_t group_lanes = 8; ///< the widest vectors' doubles

/// Column by column within a group; one that is not full takes no more room than its members.
template <Scalar T, std::size_t columns> class Groups {
public:
    void add(const std::array<T, columns>& numbers, std::uint32_t object) {
        open_[pending_++] = numbers;
        object_.push_back(object);
        if (pending_ == group_lanes) end_group();
    }
    /// The next one begins a new group.
    void end_group() {
        for (std::size_t column = 0; column < columns; ++column)
            for (std::size_t i = 0; i < pending_; ++i) numbers_.push_back(open_[i][column]);
        pending_ = 0;
    }
    /// After the last one: the last group is read beyond its end.
    void close() {
        numbers_.resize(numbers_.size() + group_lanes);
        numbers_.shrink_to_fit();
        object_.shrink_to_fit();
    }
    [[nodiscard]] std::size_t size() const { return object_.size(); }
    /// What was added at this place.
    [[nodiscard]] std::uint32_t operator[](std::size_t place) const { return object_[place]; }
    [[nodiscard]] std::size_t bytes() const {
        return numbers_.capacity() * sizeof(T) + object_.capacity() * sizeof(std::uint32_t);
    }

    /// Calls hit(object) for each of the members first … last − 1, which are whole groups, whose bit is set in
    /// near(numbers, count), until it returns true. `numbers` has no bounds: lanes beyond the count read the next numbers.
    /// @return the member after the one that ended it, or `last`
    template <typename Near, typename OnHit>
    std::size_t each(std::size_t first, std::size_t last, const Near& near, const OnHit& hit) const {
        for (; first < last; first += group_lanes) {
            const std::size_t count = std::min(group_lanes, last - first);
            unsigned left = near(&numbers_[columns * first], count) & ((1U << count) - 1U);
            for (; left != 0; left &= left - 1) {
                const auto i = std::size_t(std::countr_zero(left));
                if (hit(object_[first + i])) return first + i + 1;
            }
        }
        return last;
    }

private:
    std::array<std::array<T, columns>, group_lanes> open_;
    std::size_t pending_ = 0;
    std::vector<T> numbers_;
    std::vector<std::uint32_t> object_;
};

} // namespace rayscope
