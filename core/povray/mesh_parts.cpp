#include "core/povray/mesh_parts.hpp"

#include <map>
#include <numeric>
#include <vector>

namespace rayscope::povray {
namespace {

/// Sets of vertices, each with one of them for its name.
class Sets {
public:
    explicit Sets(std::size_t size) : of_(size) { std::iota(of_.begin(), of_.end(), 0U); }
    [[nodiscard]] std::uint32_t name(std::uint32_t vertex) {
        while (of_[vertex] != vertex) vertex = of_[vertex] = of_[of_[vertex]];
        return vertex;
    }
    void unite(std::uint32_t a, std::uint32_t b) { of_[name(a)] = name(b); }

private:
    std::vector<std::uint32_t> of_;
};

} // namespace

bool parts_may_overlap(const MeshData& mesh) {
    constexpr std::size_t most = 64; // parts: who has more is told without a look
    Sets sets(mesh.positions.size());
    for (const MeshData::Corners& t : mesh.triangles) {
        sets.unite(t[0], t[1]);
        sets.unite(t[0], t[2]);
    }
    std::map<std::uint32_t, Box<double>> parts;
    for (const MeshData::Corners& t : mesh.triangles)
        for (const std::uint32_t corner : t) parts[sets.name(corner)].include(mesh.positions[corner]);
    if (parts.size() > most) return true;
    for (auto a = parts.begin(); a != parts.end(); ++a)
        for (auto b = std::next(a); b != parts.end(); ++b)
            if (a->second.overlaps(b->second)) return true;
    return false;
}

} // namespace rayscope::povray
