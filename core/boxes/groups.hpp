#pragma once
// Shapes of one kind in groups, each group's numbers side by side in memory: what a tree tests in a leaf.

#include "core/math/numbers.hpp"
#include "core/math/ray.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <vector>

namespace rayscope {

/// A ray made ready for groups: in floats, in units of a tree whose coordinates are below 2.
struct GroupRay {
    /// @param scale see tree_scale
    GroupRay(const Ray<double>& ray, double scale)
        : size(largest_component(absolute(ray.origin)) * scale + 2),
          x(float(ray.origin.x * scale)),
          y(float(ray.origin.y * scale)),
          z(float(ray.origin.z * scale)) {
        const float length = sqrt(float(dot(ray.direction, ray.direction))), inverse = 1 / length;
        dx = float(ray.direction.x) * inverse, dy = float(ray.direction.y) * inverse,
        dz = float(ray.direction.z) * inverse;
        per_t_ = double(length) * scale;
        reliable_ = size < 0x1p20 && length > shortest && length < 1 / shortest;
    }
    /// False where numbers are so large or small that floats, or boxes in floats, can't be relied on.
    [[nodiscard]] bool reliable() const { return reliable_; }
    /// t in units of the tree, as far as floats go.
    [[nodiscard]] float reach(double t) const {
        return minimum(float(t * per_t_), std::numeric_limits<float>::max());
    }

    double size; ///< the largest coordinate of the origin + 2, for the tree
    /// Origin and unit direction: each component is off by 5 rounding errors at most.
    float x, y, z, dx, dy, dz;

private:
    static constexpr float shortest = limits::power_of_half<float>(60); // its square is still a float

    double per_t_;
    bool reliable_;
};

constexpr std::size_t group_lanes = 16; ///< as many floats as the widest vectors have

/// Column by column within a group; one that is not full takes no more room than its members.
template <std::size_t columns> class Groups {
public:
    void add(const std::array<float, columns>& numbers, std::uint32_t object) {
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
        return numbers_.capacity() * sizeof(float) + object_.capacity() * sizeof(std::uint32_t);
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
    std::array<std::array<float, columns>, group_lanes> open_;
    std::size_t pending_ = 0;
    std::vector<float> numbers_;
    std::vector<std::uint32_t> object_;
};

} // namespace rayscope
