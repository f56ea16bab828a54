#include "core/mesh/closed.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace rayscope {
namespace {

using Key = std::tuple<double, double, double>;

Key key(const Vec3d& p) { return {p.x, p.y, p.z}; }

// For each vertex the first one at the same place.
std::vector<std::uint32_t> first_at_same_place(const MeshData& mesh) {
    const auto& positions = mesh.positions;
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        const Key pa = key(positions[a]), pb = key(positions[b]);
        return pa < pb || (pa == pb && a < b);
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0, begin = 0; i < order.size(); ++i) {
        if (key(positions[order[i]]) != key(positions[order[begin]])) begin = i;
        first[order[i]] = order[begin];
    }
    return first;
}

// An edge between two vertices, the smaller number first, and which way a triangle runs along it: one number, so that
// they are sorted quickly.
struct Run {
    static constexpr int bits = 31;
    std::uint64_t code;

    Run(std::uint32_t from, std::uint32_t to)
        : code(std::uint64_t(std::min(from, to)) << (bits + 1) | std::uint64_t(std::max(from, to)) << 1 |
               std::uint64_t(from > to)) {}
    [[nodiscard]] std::uint64_t edge() const { return code >> 1; }
    [[nodiscard]] bool backwards() const { return (code & 1U) != 0; }
    [[nodiscard]] std::uint32_t low() const { return std::uint32_t(code >> (bits + 1)); }
    [[nodiscard]] std::uint32_t high() const { return std::uint32_t(code >> 1 & ((1U << bits) - 1)); }
    friend bool operator<(const Run& a, const Run& b) { return a.code < b.code; }
};

} // namespace

std::optional<Hole> find_hole(const MeshData& mesh) {
    std::vector<Run> runs;
    runs.reserve(mesh.triangles.size() * 3);
    {
        const std::vector<std::uint32_t> same = first_at_same_place(mesh);
        for (const MeshData::Corners& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i)
                if (const auto from = same[t[i]], to = same[t[(i + 1) % 3]]; from != to)
                    runs.emplace_back(from, to);
    }
    std::sort(runs.begin(), runs.end());
    for (std::size_t first = 0; first < runs.size();) {
        int along = 0, against = 0;
        std::size_t last = first;
        for (; last < runs.size() && runs[last].edge() == runs[first].edge(); ++last)
            ++(runs[last].backwards() ? against : along);
        if (along != against) return Hole{runs[first].low(), runs[first].high(), along, against};
        first = last;
    }
    return std::nullopt;
}

double signed_volume(const MeshData& mesh) {
    // From a vertex, not from the origin: far away the sum would be rounding.
    double sum = 0;
    for (const MeshData::Corners& t : mesh.triangles) {
        const Vec3d& origin = mesh.positions[mesh.triangles.front()[0]];
        sum += dot(mesh.positions[t[0]] - origin,
                   cross(mesh.positions[t[1]] - origin, mesh.positions[t[2]] - origin));
    }
    return sum;
}

} // namespace rayscope
