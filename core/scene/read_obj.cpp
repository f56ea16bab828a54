#include "core/scene/mesh_builder.hpp"
#include "core/scene/mesh_file.hpp"
#include "core/scene/obj_check.hpp"
#include "core/scene/obj_lines.hpp"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <streambuf>

namespace rayscope {
namespace {

// The text as a stream, without a copy, that knows the line it is at.
class TextBuffer : public std::streambuf {
public:
    explicit TextBuffer(std::string_view text) {
        char* const begin = const_cast<char*>(text.data()); // only read
        setg(begin, begin, begin + text.size());
    }
    // Of the character that was taken last.
    [[nodiscard]] int line() const {
        const std::string_view taken(eback(), std::size_t(gptr() - eback()) - (gptr() > eback() ? 1 : 0));
        int line = 1;
        for (std::size_t i = 0; i < taken.size(); ++i)
            if (taken[i] == '\n' || (taken[i] == '\r' && !taken.substr(i + 1).starts_with('\n'))) ++line;
        return line;
    }
};

class ObjReader {
public:
    ObjReader(std::string_view text, ObjNumbers numbers, std::string file)
        : buffer_(text), file_(std::move(file)), normals_given_(std::move(numbers.normals)) {
        builder_.mesh.first_number = 1;
        builder_.mesh.positions = std::move(numbers.positions);
        builder_.mesh.normals.emplace_back(0); // of corners without one
    }

    MeshData read() {
        std::istream stream(&buffer_);
        tinyobj::callback_t calls;
        calls.vertex_cb = [](void* self, double, double, double, double) {
            static_cast<ObjReader*>(self)->pass_vertex();
        };
        calls.normal_cb = [](void* self, double, double, double) {
            static_cast<ObjReader*>(self)->add_normal();
        };
        calls.index_cb = [](void* self, tinyobj::index_t* corners, int count) {
            static_cast<ObjReader*>(self)->add_face({corners, std::size_t(count)});
        };
        tinyobj::LoadObjWithCallback(stream, calls, this);
        MeshData& mesh = builder_.mesh;
        if (mesh.triangles.empty()) throw InputError(file_, {}, "expected faces (f), found none");
        if (!has_normals_) {
            mesh.normals = {};
            mesh.triangle_normals = {};
        }
        return std::move(mesh);
    }

private:
    void pass_vertex() { (void)checked(builder_.mesh.positions[vertices_passed_++], "coordinates"); }
    void add_normal() {
        builder_.add_normal(checked(normals_given_[builder_.mesh.normals.size() - 1], "a normal"));
    }

    void add_face(std::span<const tinyobj::index_t> corners) {
        vertices_.clear();
        normals_.clear();
        bool smooth = true;
        for (const tinyobj::index_t& corner : corners) {
            vertices_.push_back(resolved(corner.vertex_index, vertices_passed_, "vertex"));
            smooth = smooth && corner.normal_index != 0;
            if (smooth)
                normals_.push_back(resolved(corner.normal_index, builder_.mesh.normals.size() - 1, "normal") +
                                   1);
        }
        if (!smooth) normals_.assign(corners.size(), 0);
        if (smooth && !has_normals_) { // what came before is flat
            has_normals_ = true;
            builder_.mesh.triangle_normals.resize(builder_.mesh.triangles.size());
        }
        builder_.add_face(vertices_, has_normals_ ? std::span<const std::uint32_t>(normals_)
                                                  : std::span<const std::uint32_t>());
        if (builder_.mesh.triangles.size() > TriangleMesh::most_triangles)
            fail("the mesh has more than 2^27 triangles");
    }

    // Counted from 1, or with a minus from the last one.
    [[nodiscard]] std::uint32_t resolved(int index, std::size_t count, std::string_view what) const {
        const std::int64_t at = index > 0 ? std::int64_t(index) - 1 : std::int64_t(count) + index;
        if (index == 0 || at < 0 || at >= std::int64_t(count))
            fail(fmt::format("there is no {} {}: {} stand above", what, index, count));
        return std::uint32_t(at);
    }

    [[nodiscard]] const Vec3d& checked(const Vec3d& v, std::string_view what) const {
        if (!(largest_component(absolute(v)) <= mesh_limits::most) || v != v)
            fail(fmt::format("expected {} of at most {:g} in size, found ({}, {}, {})", what,
                             mesh_limits::most, v.x, v.y, v.z));
        return v;
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw InputError(file_, {buffer_.line(), 0}, message);
    }

    TextBuffer buffer_;
    std::string file_;
    MeshBuilder builder_;
    std::size_t vertices_passed_ = 0; // of the positions, which all are there from the beginning
    std::vector<Vec3d> normals_given_;
    bool has_normals_ = false;
    std::vector<std::uint32_t> vertices_, normals_;
};

} // namespace

MeshData parse_obj(std::string text, std::string file) {
    text = tidied_obj(std::move(text));
    ObjNumbers numbers = check_obj(text, file);
    return ObjReader(text, std::move(numbers), std::move(file)).read();
}

} // namespace rayscope
