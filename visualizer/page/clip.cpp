#include "visualizer/page/clip.hpp"

#include <algorithm>
#include <map>

namespace rayscope::page {
namespace {

constexpr std::size_t most_nodes = 400; // each leaf asks all others
constexpr double shared_face = 1e-6; // a face that two leaves share belongs to the left one: moved by so much

class Cutter {
public:
    Cutter(const Triangles& whole, const std::function<double(const Vec3d&)>& value)
        : whole_(whole), value_(value) {
        for (const Vec3d& corner : whole.corners) values_.push_back(value(corner));
        kept_.assign(whole.corners.size(), none);
    }

    Triangles cut() {
        for (const auto& triangle : whole_.triangles) add(triangle);
        return std::move(result_);
    }

private:
    using Index = std::uint32_t;
    static constexpr Index none = ~0U;

    [[nodiscard]] bool keeps(Index corner) const { return values_[corner] < 0; }

    void add(std::array<Index, 3> t) {
        const auto count = std::ranges::count_if(t, [&](Index corner) { return keeps(corner); });
        if (count == 0) return;
        if (count == 3) {
            result_.triangles.push_back({kept(t[0]), kept(t[1]), kept(t[2])});
            return;
        }
        // The corner that differs from the two others comes first.
        const bool odd = count == 1;
        while (keeps(t[0]) != odd) std::ranges::rotate(t, t.begin() + 1);
        const Index ab = border(t[0], t[1]), ac = border(t[0], t[2]);
        if (odd) {
            result_.triangles.push_back({kept(t[0]), ab, ac});
        } else {
            result_.triangles.push_back({ab, kept(t[1]), kept(t[2])});
            result_.triangles.push_back({ab, kept(t[2]), ac});
        }
    }

    Index kept(Index corner) {
        if (kept_[corner] == none) kept_[corner] = push(whole_.corners[corner]);
        return kept_[corner];
    }
    Index push(const Vec3d& p) {
        result_.corners.push_back(p);
        return Index(result_.corners.size() - 1);
    }

    /// Where the edge leaves what is kept.
    Index border(Index a, Index b) {
        const auto [at, fresh] = borders_.try_emplace(std::minmax(a, b), none);
        if (!fresh) return at->second;
        Vec3d in = whole_.corners[a], out = whole_.corners[b];
        if (!keeps(a)) std::swap(in, out);
        constexpr int halvings = 14; // finer than the corners are written
        for (int i = 0; i < halvings; ++i) {
            const Vec3d middle = (in + out) / 2.0;
            (value_(middle) < 0 ? in : out) = middle;
        }
        return at->second = push(in);
    }

    const Triangles& whole_;
    const std::function<double(const Vec3d&)>& value_;
    std::vector<double> values_;
    std::vector<Index> kept_;
    std::map<std::pair<Index, Index>, Index> borders_;
    Triangles result_;
};

/// A compound's tree, asked for values: negative inside.
class Tree {
public:
    Tree(const Scene& scene, std::size_t compound) : scene_(scene), nodes_(expand(scene, compound)) {
        parents_.assign(nodes_.size(), nodes_.size());
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            to_object_.emplace_back(nodes_[i].operation == Operation::leaf ? nodes_[i].matrix : Mat4d{1});
            if (nodes_[i].operation == Operation::leaf) continue;
            parents_[nodes_[i].left] = i;
            if (nodes_[i].operation != Operation::complement) parents_[nodes_[i].right] = i;
        }
    }

    [[nodiscard]] const auto& nodes() const { return nodes_; }
    [[nodiscard]] bool alone(std::size_t leaf) const { return parents_[leaf] == nodes_.size(); }
    /// An odd number of subtractions and complements above turns a leaf's surface.
    [[nodiscard]] bool turned(std::size_t leaf) const {
        bool turned = false;
        for (std::size_t child = leaf; parents_[child] < nodes_.size(); child = parents_[child]) {
            const auto& parent = nodes_[parents_[child]];
            turned ^= parent.operation == Operation::complement ||
                      (parent.operation == Operation::difference && parent.right == child);
        }
        return turned;
    }

    /// Negative where a point of a leaf's surface is one of the compound's.
    [[nodiscard]] double border_value(std::size_t leaf, const Vec3d& p) const {
        double largest = -1;
        for (std::size_t child = leaf; parents_[child] < nodes_.size(); child = parents_[child]) {
            const auto& parent = nodes_[parents_[child]];
            if (parent.operation == Operation::complement) continue;
            const bool left = parent.left == child;
            const double v = value(left ? parent.right : parent.left, p);
            const double tie = left ? shared_face : -shared_face;
            switch (parent.operation) {
            case Operation::set_union: largest = std::max(largest, -v - tie); break;
            case Operation::intersection: largest = std::max(largest, v - tie); break;
            default: largest = std::max(largest, (left ? -v : v) + shared_face); break;
            }
        }
        return largest;
    }

private:
    [[nodiscard]] double value(std::size_t node, const Vec3d& p) const {
        const auto& n = nodes_[node];
        switch (n.operation) {
        case Operation::leaf:
            return implicit_value(scene_.generics[n.generic].shape, to_object_[node].point_to_object(p));
        case Operation::set_union: return std::min(value(n.left, p), value(n.right, p));
        case Operation::intersection: return std::max(value(n.left, p), value(n.right, p));
        case Operation::difference: return std::max(value(n.left, p), -value(n.right, p));
        default: return -value(n.left, p);
        }
    }

    const Scene& scene_;
    std::vector<ExpandedNode> nodes_;
    std::vector<std::size_t> parents_;
    std::vector<Transform<double>> to_object_;
};

} // namespace

Triangles clipped(const Triangles& whole, const std::function<double(const Vec3d&)>& value) {
    return Cutter(whole, value).cut();
}

Triangles compound_surface(const Scene& scene, std::size_t compound, int around, const Ball& shown) {
    const Tree tree(scene, compound);
    Triangles surface;
    if (tree.nodes().size() > most_nodes) return surface;
    for (std::size_t leaf = 0; leaf < tree.nodes().size(); ++leaf) {
        const auto& node = tree.nodes()[leaf];
        if (node.operation != Operation::leaf) continue;
        const bool cut = !tree.alone(leaf);
        Triangles piece = tessellate(scene.generics[node.generic].shape, node.matrix, around, cut, shown);
        if (cut) piece = clipped(piece, [&](const Vec3d& p) { return tree.border_value(leaf, p); });
        if (tree.turned(leaf))
            for (auto& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
        surface.append(piece);
    }
    return surface;
}

} // namespace rayscope::page
