// The drawn surface of a compound is its boundary.

#include "tests/drawing/bowl.hpp"
#include "tests/support/scenes.hpp"
#include "visualizer/drawing/clip_compound.hpp"

#include <gtest/gtest.h>

namespace rayscope::test {
namespace {

using namespace rayscope::drawing;

const Region around_origin{Vec3d{0}, 2, {}};

std::size_t drawn_index(const Scene& scene, const std::string& compound) {
    for (std::size_t i = 0; i < scene.drawn.size(); ++i)
        if (scene.drawn[i].is_compound && scene.compounds[scene.drawn[i].index].name == compound) return i;
    ADD_FAILURE() << compound;
    return 0;
}

TEST(Surfaces, the_bowl_has_an_outer_wall_an_inner_wall_and_a_rim) {
    const Scene& scene = bowl().scene;
    const Pieces pieces = object_surface(scene, drawn_index(scene, "bowl"), {96, false}, around_origin);
    ASSERT_EQ(pieces.size(), 3U);
    std::vector<std::pair<Generic<double>, Transform<double>>> parts;
    for (const char* name : {"outer", "inner", "mouth"})
        for (const SceneGeneric& generic : scene.generics)
            if (generic.name == name) parts.emplace_back(generic.shape, Transform<double>(generic.matrix));
    ASSERT_EQ(parts.size(), 3U);
    for (const auto& piece : pieces)
        for (vtkIdType i = 0; i < piece->GetNumberOfPoints(); ++i) {
            const Vec3d p = point_of(piece, i);
            const auto at = [&](std::size_t part) {
                return implicit_value(parts[part].first, parts[part].second.point_to_object(p));
            };
            // A rim is cut across cells by straight lines: it is off by the square of a cell's size.
            const double bowl = std::max({at(0), -at(1), -at(2)});
            EXPECT_NEAR(bowl, 0, 5e-3) << p.x << " " << p.y << " " << p.z;
        }
}

TEST(Surfaces, normals_point_out_of_every_generic_mirrored_ones_too) {
    for (const double side : {1.0, -1.0}) {
        Mat4d matrix{1};
        matrix[0][0] = side * 2;
        matrix[3] = {5, 6, 7, 1};
        const std::vector<Generic<double>> shapes{Sphere<double>{}, Cylinder<double>{}, Cone<double>{0.3},
                                                  Cube<double>{}, Torus<double>{0.3}};
        for (const Generic<double>& shape : shapes)
            for (const auto& piece : tessellate(shape, matrix, {24, false}, around_origin)) {
                const Transform<double> transform(matrix);
                ASSERT_GT(piece->GetNumberOfPolys(), 0) << generic_name(shape);
                // The middle of a cell, moved along its corners' normal, leaves the solid.
                std::array<vtkIdType, 4> ids{};
                for (vtkIdType cell = 0; cell < piece->GetNumberOfCells(); ++cell) {
                    const auto corners = piece->GetCell(cell);
                    ids[0] = corners->GetPointId(0);
                    const Vec3d a = point_of(piece, ids[0]), b = point_of(piece, corners->GetPointId(1)),
                                c = point_of(piece, corners->GetPointId(2));
                    const Vec3d n = cross(b - a, c - a);
                    if (!(length(n) > 1e-6)) continue; // at a pole
                    const Vec3d middle = (a + b + c) / 3.0;
                    const auto value = [&](const Vec3d& p) {
                        return implicit_value(shape, transform.point_to_object(p));
                    };
                    EXPECT_GT(value(middle + normalized(n) * 0.05), value(middle - normalized(n) * 0.05))
                        << generic_name(shape) << ", cell " << cell;
                }
            }
    }
}

TEST(Surfaces, a_hidden_operand_leaves_no_piece) {
    SceneBuilder builder;
    Mat4d half{0.5};
    half[3][3] = 1;
    builder.operand("large", Sphere<double>{});
    builder.operand("small", Sphere<double>{}, half);
    builder.compound("both", "large | small", builder.glowing(Colour{1}));
    EXPECT_EQ(object_surface(builder.scene(), 0, {48, false}, around_origin).size(), 1U);
    SceneBuilder none_left;
    none_left.operand("large", Sphere<double>{});
    none_left.operand("small", Sphere<double>{}, half);
    none_left.compound("nothing", "small - large", none_left.glowing(Colour{1}));
    EXPECT_TRUE(object_surface(none_left.scene(), 0, {48, false}, around_origin).empty());
}

} // namespace
} // namespace rayscope::test
