// What is read from OBJ and PLY, and what is said of files that are wrong.

#include "core/scene/mesh_file.hpp"
#include "tests/support/effort.hpp"
#include "tests/support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

namespace rayscope::test {
namespace {

template <typename Parse> std::string said(const Parse& parse) {
    try {
        (void)parse();
        return "no error";
    } catch (const InputError& error) {
        return error.what();
    }
}
std::string obj_error(const std::string& text) {
    return said([&] { return parse_obj(text, "m.obj"); });
}
std::string ply_error(const std::string& text) {
    return said([&] { return parse_ply(text, "m.ply"); });
}

constexpr const char* pyramid = "# closed\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv .5 .5 1\n"
                                "f 1 4 3 2\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

TEST(Obj, closed_pyramid) {
    const MeshData data = parse_obj(pyramid, "m.obj");
    EXPECT_EQ(data.positions.size(), 5U);
    EXPECT_EQ(data.triangles.size(), 6U);
    EXPECT_FALSE(data.smooth());
    EXPECT_EQ(data.first_number, 1);
    EXPECT_FALSE(find_hole(data));
}

TEST(Obj, corners_may_be_counted_from_the_last_and_have_normals) {
    const MeshData data = parse_obj("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nvn 0 0 2\r\nvn 1 0 0\r\nvt 0 0\r\n"
                                    "f -3//1 -2/1/1 3//-1\r\nf 1 2 3\r\n",
                                    "m.obj");
    ASSERT_EQ(data.triangles.size(), 2U);
    EXPECT_EQ(data.triangles[0], (MeshData::Corners{0, 1, 2}));
    EXPECT_EQ(data.normals[data.normals_of(0)[1]], Vec3<float>(0, 0, 1));
    EXPECT_EQ(data.normals[data.normals_of(0)[2]], Vec3<float>(1, 0, 0));
    EXPECT_EQ(data.normals[data.normals_of(1)[0]], Vec3<float>(0)); // flat
}

TEST(Obj, numbers_are_rounded_once_so_that_one_place_is_one_vertex) {
    const char* text =
        "v 0 0 0\nv 0.3 0 0\nv 0 1 0\nv 0 0 1\nv 3e-1 0 0\nv 30e-2 0 0\nvn 0.1 12345.6789 1e-3\n"
        "f 1 3 2\nf 1 5 4\nf 1 4 3\nf 6 3 4\n";
    const MeshData data = parse_obj(text, "m.obj");
    for (const std::size_t i : {1U, 4U, 5U}) EXPECT_EQ(data.positions[i], (Vec3d{0.3, 0, 0}));
    EXPECT_FALSE(find_hole(data));
    EXPECT_EQ(obj_error("v 0 0 0\nv 1e400 0 0\n"), "m.obj:2:3: expected a number, found '1e400'");
    EXPECT_EQ(obj_error("v 0 0 +-1\n"), "m.obj:1:7: expected a number, found '+-1'");
}

TEST(Obj, lines_may_be_continued_and_end_in_comments) {
    const MeshData data = parse_obj(
        "\xEF\xBB\xBFv 0 0 0 # first\nv 1 0 \\\r\n 0\nv 0 1 0\ng a#b\nf 1 \\\n 2 3 # all\n", "m.obj");
    ASSERT_EQ(data.positions.size(), 3U);
    EXPECT_EQ(data.positions[1], (Vec3d{1, 0, 0}));
    ASSERT_EQ(data.triangles.size(), 1U);
    EXPECT_EQ(data.triangles[0], (MeshData::Corners{0, 1, 2}));
    const MeshData old_mac = parse_obj("# C:\\models\\\rv 0 0 \\\r 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r", "m.obj");
    EXPECT_EQ(old_mac.positions.size(), 3U); // the comment's backslash continues nothing
    try {
        (void)parse_obj("v 0 0 \\\n0\nv 1 0 0\nf 1 2 3 # too few\n", "m.obj");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "m.obj:4: there is no vertex 3: 2 stand above");
    }
}

TEST(Obj, errors_name_line_and_expectation) {
    EXPECT_EQ(obj_error("v 0 0 0\nv 1 x 0\n"), "m.obj:2:5: expected a number, found 'x'");
    EXPECT_EQ(obj_error("v 0 0\n"), "m.obj:1:1: expected 3 to 7 numbers, found 2");
    EXPECT_EQ(obj_error("v 0 0 nan\n"), "m.obj:1:7: expected a number, found 'nan'");
    EXPECT_EQ(obj_error("v 0 -inf 0\n"), "m.obj:1:5: expected a number, found '-inf'");
    EXPECT_EQ(obj_error("vn infinity 0 0\n"), "m.obj:1:4: expected a number, found 'infinity'");
    EXPECT_EQ(obj_error("v 0 0 0\nf 1 1\n"), "m.obj:2:1: expected a face of 3 to 1024 corners, found 2");
    EXPECT_EQ(obj_error("v 0 0 0\n\nf 1 1 2\n"), "m.obj:3: there is no vertex 2: 1 stand above");
    EXPECT_EQ(obj_error("v 0 0 0\nf 1 1 -2\n"), "m.obj:2: there is no vertex -2: 1 stand above");
    EXPECT_EQ(obj_error("v 0 0 0\nf 1//1 1//1 1//1\n"), "m.obj:2: there is no normal 1: 0 stand above");
    EXPECT_EQ(obj_error("v 0 0 0\n"), "m.obj: expected faces (f), found none");
    EXPECT_EQ(obj_error("v 1e200 0 0\n"),
              "m.obj:1: expected coordinates of at most 1e+100 in size, found (1e+200, 0, 0)");
    for (const char* corner : {"0", "1/", "1//", "1/2/3/4", "a", "1.5", "99999999999", "1//x", "/1"})
        EXPECT_NE(
            obj_error("v 0 0 0\nf 1 1 " + std::string(corner) + "\n").find("m.obj:2:7: expected a corner"),
            std::string::npos)
            << corner << ": " << obj_error("v 0 0 0\nf 1 1 " + std::string(corner) + "\n");
    EXPECT_EQ(obj_error(std::string("v 0 0 0\0\n", 9)), "m.obj:1: expected a text, found a byte of value 0");
}

std::string ply_header(const std::string& format, const std::string& vertices = "4",
                       const std::string& faces = "4") {
    return "ply\nformat " + format + " 1.0\ncomment c\nelement vertex " + vertices +
           "\nproperty float x\nproperty double y\nproperty float z\nelement face " + faces +
           "\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n";
}
constexpr const char* tetrahedron =
    "0 0 0\n1 0 0\n0 1 0\n0 0 1\n9 3 0 2 1\n9 3 0 1 3\n9 3 0 3 2\n9 3 1 2 3\n";

template <typename Number> void put(std::string& out, Number x, bool big) {
    std::array<char, sizeof x> bytes = std::bit_cast<std::array<char, sizeof x>>(x);
    if (big) std::reverse(bytes.begin(), bytes.end());
    out.append(bytes.data(), bytes.size());
}
std::string binary_body(bool big) {
    std::string body;
    const std::array<Vec3d, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (const Vec3d& p : corners) {
        put(body, float(p.x), big);
        put(body, p.y, big);
        put(body, float(p.z), big);
    }
    for (const std::array<std::int32_t, 3>& f :
         {std::array<std::int32_t, 3>{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}) {
        body += "\x09\x03";
        for (const std::int32_t corner : f) put(body, corner, big);
    }
    return body;
}

TEST(Ply, text_and_both_byte_orders_are_the_same_mesh) {
    const MeshData text = parse_ply(ply_header("ascii") + tetrahedron, "m.ply");
    EXPECT_EQ(text.triangles.size(), 4U);
    EXPECT_FALSE(find_hole(text));
    EXPECT_GT(signed_volume(text), 0);
    for (const bool big : {false, true}) {
        const MeshData data = parse_ply(
            ply_header(big ? "binary_big_endian" : "binary_little_endian") + binary_body(big), "m.ply");
        EXPECT_EQ(data.positions, text.positions);
        EXPECT_EQ(data.triangles, text.triangles);
    }
}

TEST(Ply, normals_and_polygons) {
    const MeshData data =
        parse_ply("ply\nformat ascii 1.0\nelement edge 1\nproperty int a\nelement vertex 5\n"
                  "property float x\nproperty float y\nproperty float z\nproperty float nx\n"
                  "property float ny\nproperty float nz\nelement face 1\n"
                  "property list uchar int vertex_index\nend_header\n7\n"
                  "0 0 0 0 0 1\n2 0 0 0 0 1\n2 2 0 0 0 1\n1 .1 0 0 0 1\n0 2 0 0 0 3\n5 0 1 2 3 4\n",
                  "m.ply");
    EXPECT_EQ(data.triangles.size(), 3U);
    ASSERT_TRUE(data.smooth());
    EXPECT_EQ(data.normals[4], Vec3<float>(0, 0, 1));
}

TEST(Ply, errors_name_line_and_expectation) {
    EXPECT_EQ(ply_error("plx\n"), "m.ply:1: expected 'ply', the first line of a PLY file");
    EXPECT_EQ(ply_error("ply\nformat ascii 2.0\n"),
              "m.ply:2: expected 'format ascii 1.0', or binary_little_endian or binary_big_endian in place "
              "of ascii");
    EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement vertex x\n"),
              "m.ply:3: expected 'element NAME COUNT', for example 'element vertex 8'");
    EXPECT_EQ(
        ply_error("ply\nformat ascii 1.0\nelement vertex 3\nproperty quad x\n"),
        "m.ply:4: expected a type: char, uchar, short, ushort, int, uint, float or double; found 'quad'");
    EXPECT_EQ(ply_error("ply\nformat ascii 1.0\n"),
              "m.ply:3: expected 'end_header', found the end of the file");
    EXPECT_EQ(ply_error(ply_header("ascii", "4000000000") + tetrahedron),
              "m.ply: expected 4000000000 elements 'vertex', but the file has room for 10 at most");
    EXPECT_EQ(ply_error(ply_header("binary_little_endian", "4", "99999999999999999999")),
              "m.ply:8: expected 'element NAME COUNT', for example 'element vertex 8'");
    EXPECT_EQ(ply_error(ply_header("ascii") + "0 0 0\n1 0 0\n0 y 0\n" + std::string(40, ' ')),
              "m.ply:14: expected a number, found 'y'");
    EXPECT_EQ(ply_error(ply_header("ascii", "1", "1") + "0 0 0\n9 3 0 0 1\n"),
              "m.ply:13: face 0 (from 0): expected vertices from 0 to 0, found 1");
    EXPECT_EQ(ply_error(ply_header("ascii", "1", "1") + "0 0 0\n9 3 0 0 -1\n"),
              "m.ply:13: face 0 (from 0): expected vertices from 0 to 0, found -1");
    EXPECT_EQ(ply_error(ply_header("ascii", "1", "1") + "0 0 0\n9 2 0 0\n"),
              "m.ply:13: face 0 (from 0): expected at least 3 corners, found 2");
    EXPECT_EQ(
        ply_error(ply_header("ascii", "1", "1") + "0 nan 0\n9 3 0 0 0\n"),
        "m.ply:12: vertex 0 (from 0): expected coordinates of at most 1e+100 in size, found (0, nan, 0)");
    EXPECT_EQ(
        ply_error(ply_header("ascii", "1", "0") + "0 0 0\n"),
        "m.ply:12: expected faces: 'element face COUNT' in the header (a cloud of points has no surface)");
    const std::string whole = ply_header("binary_little_endian") + binary_body(false);
    EXPECT_EQ(ply_error(whole.substr(0, whole.size() - 1)),
              "m.ply: at byte 315 (from 0): expected more numbers, found the end of the file");
    EXPECT_EQ(ply_error("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
                        "element vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
                        "end_header\n3 0 0 0\n0 0 0\n"),
              "m.ply:10: expected the element 'vertex' to stand before the element 'face'");
}

TEST(Ply, nothing_may_follow_that_the_header_does_not_count) {
    EXPECT_EQ(ply_error(ply_header("ascii") + tetrahedron + " \n\n"), "no error");
    EXPECT_EQ(ply_error(ply_header("ascii", "4", "3") + tetrahedron),
              "m.ply:19: expected the end of the file: the header counts no more elements; found '9'");
    EXPECT_EQ(ply_error(ply_header("binary_little_endian") + binary_body(false) + "\r\n"), "no error");
    EXPECT_EQ(
        ply_error(ply_header("binary_little_endian", "4", "3") + binary_body(false)),
        "m.ply: at byte 305 (from 0): expected the end of the file: the header counts no more elements; "
        "found 14 more bytes");
}

// Whatever a file is damaged to, it is read or refused.
TEST(MeshFiles, damaged_files_neither_crash_nor_hang) {
    const std::vector<std::string> whole{ply_header("ascii") + tetrahedron,
                                         ply_header("binary_little_endian") + binary_body(false),
                                         ply_header("binary_big_endian") + binary_body(true), pyramid};
    Random random(6);
    int read = 0, refused = 0;
    for (int i = 0; i < samples(20000); ++i) {
        const std::size_t which = std::size_t(random.below(int(whole.size())));
        std::string text = whole[which];
        for (int k = 1 + random.below(3); k > 0 && !text.empty(); --k) {
            const auto at = std::size_t(random.below(int(text.size())));
            switch (random.below(4)) {
            case 0: text[at] = char(random.below(256)); break;
            case 1: text.resize(at); break;
            case 2: text[at] = "0123456789-+.e/ \n"[random.below(17)]; break;
            default: text.insert(at, 1, "0123456789- \n"[random.below(13)]);
            }
        }
        try {
            const MeshData data = which == 3 ? parse_obj(text, "m") : parse_ply(text, "m");
            ASSERT_FALSE(data.triangles.empty());
            for (const auto& t : data.triangles)
                for (const std::uint32_t corner : t) ASSERT_LT(corner, data.positions.size());
            const Mesh<double> mesh = mesh_of(data);
            (void)crossings(mesh, random.towards_unit_cube(3));
            ++read;
        } catch (const InputError&) {
            ++refused;
        }
    }
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace rayscope::test
