#pragma once
// Scenes of all generics and of compounds, crowded or sparse, large beside small, some things without end.

#include "tests/support/meshes.hpp"
#include "tests/support/scenes.hpp"
#include "tests/support/shapes.hpp"

namespace rayscope::test {

/// @param count of objects
[[nodiscard]] inline Scene random_scene(Random& random, int count) {
    SceneBuilder b;
    const std::size_t opaque = b.clear(0.3, 0, 1), glass = b.clear(0.1, 0.8, 1.5);
    static const std::vector<Mesh<double>> meshes{
        mesh_of(globe_data(12, 0.3)), mesh_of(bowl_data(10)),
        mesh_of(joined(cube_data(), cube_data({1, 0.5, 0.2}, 0.7)))};
    auto shapes = all_generics();
    auto solids = solid_generics();
    shapes.insert(shapes.end(), meshes.begin(), meshes.end());
    solids.emplace_back(meshes[0]);
    const double spread = random.decade(0, 1.5);
    const auto place = [&] {
        const double size = random.decade(-1.5, 0.3);
        Mat4d m = translation(random.in_cube(spread));
        if (random.coin()) m = m * random_rotation(random);
        if (random.below(3) == 0) m = m * shearing(random.uniform(-1, 1));
        if (random.below(8) == 0) // pressed flat, at right angles to none of its own axes
            m = m * scaling(1, 1, random.decade(-5, -1)) * random_rotation(random);
        return random.coin()
                   ? m * scaling(size)
                   : m * scaling(size * random.uniform(0.2, 1), -size, size * random.uniform(0.2, 1));
    };
    for (int i = 0; i < count; ++i) {
        const std::size_t material = random.below(3) == 0 ? glass : opaque;
        if (random.below(4) == 0) {
            const std::string n = std::to_string(i);
            const Mat4d m = place();
            for (const char* part : {"a", "b", "c"}) {
                const auto& shape = solids[std::size_t(random.below(int(solids.size())))];
                b.operand(part + n, shape,
                          m * translation(random.in_cube(0.7)) * scaling(random.uniform(0.3, 1)));
            }
            const std::string first = "a" + n, second = "b" + n, third = "c" + n;
            const std::string expressions[] = {
                first + "-" + second + "-" + third, first + "&" + second + "|" + third, first + "&!" + second,
                "(" + first + "|" + second + ")&" + third, first + "-(" + second + "&" + third + ")"};
            b.compound("compound" + n, expressions[random.below(5)], material);
            continue;
        }
        if (random.below(10) == 0) { // of many parts, most of which a ray misses
            const Mat4d m = place();
            std::string expression;
            for (int part = 0, parts = 4 + random.below(20); part < parts; ++part) {
                const std::string name = "p" + std::to_string(i) + "_" + std::to_string(part);
                const auto& shape = solids[std::size_t(random.below(int(solids.size())))];
                b.operand(name, shape,
                          m * translation(random.in_cube(2)) *
                              scaling(part == 0 ? 2 : random.uniform(0.1, 0.5)));
                const char* const operations[] = {"|", "-", "|"};
                expression += (part > 0 ? operations[random.below(3)] : "") + name;
            }
            b.compound("many" + std::to_string(i), expression, material);
            continue;
        }
        // Mostly what has an end: a plane in every scene would hide the rest.
        std::size_t kind = std::size_t(random.below(int(shapes.size())));
        if (std::holds_alternative<Plane<double>>(shapes[kind]) && random.below(8) != 0) kind = 0;
        b.generic(shapes[kind], place(), material, "g" + std::to_string(i));
    }
    return b.scene();
}

} // namespace rayscope::test
