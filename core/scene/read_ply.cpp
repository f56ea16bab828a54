// A reader of our own. The one that Debian 12 offers, assimp 5.2, reads a million triangles in a quarter of a second, but
// crashed or hung on one in twelve of files with a damaged header, took indices of vertices that are not there, and keeps
// floats only; what would have to be checked before it and after it is this.

#include "core/scene/mesh_builder.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/ply_body.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rayscope {
namespace {

using Columns = std::array<std::size_t, 3>;

std::optional<Columns> columns_of(const PlyElement& element, const std::array<std::string_view, 3>& names) {
    Columns columns{};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto at = element.find(names[i]);
        if (!at || element.properties[*at].count) return std::nullopt;
        columns[i] = *at;
    }
    return columns;
}

template <typename Body> class PlyReader {
public:
    PlyReader(const PlyHeader& header, Body body) : header_(header), body_(std::move(body)) {}

    MeshData read() {
        for (const PlyElement& element : header_.elements) {
            if (element.name == "vertex")
                read_vertices(element);
            else if (element.name == "face")
                read_faces(element);
            else
                each(element, [](std::size_t) {});
        }
        if (builder_.mesh.positions.empty())
            body_.fail("expected vertices: 'element vertex COUNT' in the header");
        if (builder_.mesh.triangles.empty())
            body_.fail(
                "expected faces: 'element face COUNT' in the header (a cloud of points has no surface)");
        body_.end();
        return std::move(builder_.mesh);
    }

private:
    // Reads all of an element's properties; then done(number).
    template <typename Done> void each(const PlyElement& element, const Done& done) {
        if (element.properties.empty()) return;
        values_.resize(element.properties.size());
        for (std::size_t i = 0; i < element.count; ++i) {
            for (std::size_t p = 0; p < values_.size(); ++p) {
                const PlyProperty& property = element.properties[p];
                if (!property.count) {
                    values_[p] = body_.next(property.type);
                    continue;
                }
                const double length = body_.next(*property.count);
                const bool wanted = list_column_ && p == *list_column_;
                if (!(length >= 0) || (wanted && length > double(mesh_limits::most_corners)))
                    body_.fail(fmt::format("{} {} (from 0): expected a list of at most {} numbers, found the "
                                           "length {}",
                                           element.name, i, mesh_limits::most_corners, length));
                if (wanted) list_.clear();
                for (double k = 0; k < length; ++k) {
                    const double x = body_.next(property.type);
                    if (wanted) list_.push_back(x);
                }
            }
            done(i);
        }
    }

    void read_vertices(const PlyElement& element) {
        const auto place = columns_of(element, {"x", "y", "z"});
        if (!place) body_.fail("expected the properties x, y and z of the element 'vertex'");
        const auto normal = columns_of(element, {"nx", "ny", "nz"});
        if (!builder_.mesh.positions.empty()) body_.fail("expected one element 'vertex', found another one");
        builder_.mesh.positions.reserve(element.count);
        if (normal) builder_.mesh.normals.reserve(element.count);
        each(element, [&](std::size_t i) {
            builder_.mesh.positions.push_back(vector(*place, "coordinates", i));
            if (normal) builder_.add_normal(vector(*normal, "normal", i));
        });
    }

    [[nodiscard]] Vec3d vector(const Columns& columns, std::string_view what, std::size_t vertex) const {
        const Vec3d v{values_[columns[0]], values_[columns[1]], values_[columns[2]]};
        if (!(largest_component(absolute(v)) <= mesh_limits::most) || v != v)
            body_.fail(
                fmt::format("vertex {} (from 0): expected {} of at most {:g} in size, found ({}, {}, {})",
                            vertex, what, mesh_limits::most, v.x, v.y, v.z));
        return v;
    }

    void read_faces(const PlyElement& element) {
        for (const std::string_view name : {"vertex_indices", "vertex_index"})
            if (const auto at = element.find(name); at && element.properties[*at].count) list_column_ = at;
        if (!list_column_) body_.fail("expected the list 'vertex_indices' of the element 'face'");
        const std::size_t vertices = builder_.mesh.positions.size();
        if (vertices == 0) body_.fail("expected the element 'vertex' to stand before the element 'face'");
        builder_.mesh.triangles.reserve(element.count);
        each(element, [&](std::size_t i) {
            if (list_.size() < 3)
                body_.fail(
                    fmt::format("face {} (from 0): expected at least 3 corners, found {}", i, list_.size()));
            corners_.clear();
            for (const double index : list_) {
                if (!(index >= 0 && index < double(vertices)) || index != std::trunc(index))
                    body_.fail(fmt::format("face {} (from 0): expected vertices from 0 to {}, found {}", i,
                                           double(vertices) - 1, index));
                corners_.push_back(std::uint32_t(index));
            }
            builder_.add_face(corners_);
            if (builder_.mesh.triangles.size() > TriangleMesh::most_triangles)
                body_.fail("the mesh has more than 2^27 triangles");
        });
        list_column_.reset();
    }

    const PlyHeader& header_;
    Body body_;
    MeshBuilder builder_;
    std::vector<double> values_, list_;
    std::optional<std::size_t> list_column_;
    std::vector<std::uint32_t> corners_;
};

} // namespace

MeshData parse_ply(std::string_view text, std::string file) {
    const PlyHeader header = read_ply_header(text, file);
    if (header.format == PlyFormat::ascii) return PlyReader(header, PlyDecimals(text, header, file)).read();
    return PlyReader(header, PlyBytes(text, header, file)).read();
}

} // namespace rayscope
