#pragma once
// In which order the rays that materials ask for are followed.

#include "core/tracer/budget.hpp"
#include "core/world/work.hpp"

#include <algorithm>
#include <vector>

namespace rayscope {

/// At once, and deeper: the recursion of the notes. What comes back is weighed on the way up.
struct DepthFirst {
    static constexpr bool waits = false;
};

/// A ray that is not followed yet.
template <Scalar T> struct WaitingRay {
    RayKind kind;
    Ray<T> ray;
    Leaving<T> leaving;
    Budget budget;
};

/// The ray of the largest weight first: whenever the work ends, the least light is missing. Among equals the older one,
/// so that the sum is the same on every machine.
template <Scalar T> class LargestFirst {
public:
    static constexpr bool waits = true;

    void push(const WaitingRay<T>& next) {
        std::size_t slot = rays_.size();
        if (free_.empty()) {
            rays_.push_back(next);
        } else {
            slot = free_.back();
            free_.pop_back();
            rays_[slot] = next;
        }
        heap_.push_back({largest_component(next.budget.weight), count_++, slot});
        std::push_heap(heap_.begin(), heap_.end());
    }
    [[nodiscard]] bool empty() const { return heap_.empty(); }
    [[nodiscard]] WaitingRay<T> pop() {
        std::pop_heap(heap_.begin(), heap_.end());
        const std::size_t slot = heap_.back().slot;
        heap_.pop_back();
        free_.push_back(slot);
        return rays_[slot];
    }

    /// Light of this weight, per colour, will not be gathered.
    void lose(const Colour& weight) { lost_ += weight; }
    [[nodiscard]] const Colour& lost() const { return lost_; }

private:
    struct Entry {
        double weight;
        std::uint64_t number; // in the order of pushing
        std::size_t slot;     // in rays_: they are large, and stay where they are

        friend bool operator<(const Entry& a, const Entry& b) {
            return a.weight < b.weight || (a.weight == b.weight && a.number > b.number);
        }
    };

    std::vector<Entry> heap_;
    std::vector<WaitingRay<T>> rays_;
    std::vector<std::size_t> free_;
    std::uint64_t count_ = 0;
    Colour lost_{0};
};

} // namespace rayscope
