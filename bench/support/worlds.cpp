#include "bench/support/worlds.hpp"

namespace rayscope::bench {
namespace {

Mat4d scaled(const Vec3d& size, const Vec3d& place) {
    Mat4d matrix{1};
    for (int axis = 0; axis < 3; ++axis) matrix[axis][axis] = size[axis];
    matrix[3] = {place, 1};
    return matrix;
}

// z → y: what stands along z stands upright.
Mat4d upright(const Vec3d& size, const Vec3d& place) {
    Mat4d matrix{0};
    matrix[0][0] = size.x;
    matrix[1][2] = -size.y;
    matrix[2][1] = size.z;
    matrix[3] = {place, 1};
    return matrix;
}

// One compound, "first − second − …" or with unions before the last difference, at each place of a grid.
class Grid {
public:
    explicit Grid(int n) : n_(n), scene_(stand(2.4 * n)) {}

    std::size_t operand(const Generic<double>& shape, const Mat4d& matrix) {
        SceneGeneric generic;
        generic.shape = shape;
        generic.matrix = matrix;
        generic.visible = false;
        scene_.generics.push_back(generic);
        return scene_.generics.size() - 1;
    }
    /// The operands added so far, combined from left to right: with unions up to number `united`, then differences.
    Scene fill(std::size_t first, std::size_t united) {
        SceneCompound compound;
        compound.material = 1;
        for (std::size_t i = first; i < scene_.generics.size(); ++i) {
            compound.nodes.push_back({Operation::leaf, 0, 0, false, i, {}});
            const std::size_t last = compound.nodes.size();
            if (i > first)
                compound.nodes.push_back({i - first < united ? Operation::set_union : Operation::difference,
                                          i == first + 1 ? 0 : last - 2,
                                          last - 1,
                                          false,
                                          0,
                                          {}});
        }
        for (int i = 0; i < n_ * n_; ++i) {
            compound.matrix[3] = {(i % n_ - (n_ - 1) / 2.0) * 2.4, 0, (i / n_ - (n_ - 1) / 2.0) * 2.4, 1};
            scene_.drawn.push_back({true, scene_.compounds.size()});
            scene_.compounds.push_back(compound);
        }
        return std::move(scene_);
    }

private:
    int n_;
    Scene scene_;
};

void add_flake(Scene& scene, int level, const Vec3d& centre, double radius, const Vec3d& up) {
    SceneGeneric& ball = scene.generics.emplace_back();
    ball.shape = Sphere<double>{radius};
    ball.matrix[3] = {centre, 1};
    ball.material = 1;
    scene.drawn.push_back({false, scene.generics.size() - 1});
    if (level == 0) return;
    const Vec3d aside = normalized(cross(up, magnitude(up.x) < 0.9 ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0}));
    const Vec3d third = cross(up, aside);
    for (int i = 0; i < 9; ++i) { // three above, six around the equator
        const double angle = i < 3 ? 2.0943951023931953 * i + 0.5 : 1.0471975511965976 * i;
        const double height = i < 3 ? 0.8 : 0.0, width = i < 3 ? 0.6 : 1.0;
        const Vec3d direction = height * up + width * (std::cos(angle) * aside + std::sin(angle) * third);
        add_flake(scene, level - 1, centre + 1.5 * radius * direction, radius / 2, direction);
    }
}

} // namespace

Scene stand(double size) {
    Scene scene;
    scene.file = "bench";
    scene.background = Colour{0.3, 0.4, 0.6};
    scene.limits = {4, 0};
    scene.camera.eye = {0, 0.9 * size, 1.1 * size};
    scene.camera.field_of_view = 50;
    scene.lights.push_back({"lamp", false, {-size, 2 * size, size}, Colour{1}, true, {}, {}});
    scene.materials.resize(2);
    scene.materials[1].specular = Colour{0.3};
    scene.materials[1].reflection = Colour{0.2};
    SceneGeneric& floor = scene.generics.emplace_back();
    floor.shape = Plane<double>{};
    floor.matrix = upright({1, 1, 1}, {0, -1.2, 0});
    floor.material = 0;
    scene.drawn.push_back({false, 0});
    return scene;
}

Scene flake(int level) {
    Scene scene = stand(3);
    add_flake(scene, level, {0, 0, 0}, 0.5, {0, 1, 0});
    return scene;
}

Scene bowls(int n) {
    Grid grid(n);
    const std::size_t first = grid.operand(Sphere<double>{}, Mat4d{1});
    grid.operand(Sphere<double>{}, scaled(Vec3d{0.85}, {0, 0, 0}));
    grid.operand(Cone<double>{}, upright({1.6, 1.6, -0.8}, {0, 0.7, 0}));
    return grid.fill(first, 1);
}

Scene pierced_cylinders(int n) {
    Grid grid(n);
    const std::size_t first = grid.operand(Cylinder<double>{}, upright({1, 1, 0.8}, {0, 0, 0}));
    for (const double degrees : {90.0, 210.0, 330.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        grid.operand(Cylinder<double>{},
                     upright({0.22, 0.22, 0.9}, {0.5 * std::cos(angle), 0, 0.5 * std::sin(angle)}));
    }
    return grid.fill(first, 1);
}

Scene gears(int n) {
    constexpr int teeth = 12;
    Grid grid(n);
    const std::size_t first = grid.operand(Cylinder<double>{}, upright({0.9, 0.9, 0.3}, {0, 0, 0}));
    for (int i = 0; i < teeth; ++i) {
        const double angle = 2 * std::numbers::pi * i / teeth, c = std::cos(angle), s = std::sin(angle);
        Mat4d tooth{1};
        tooth[0] = {0.12 * c, 0, 0.12 * s, 0};
        tooth[1] = {0, 0.28, 0, 0};
        tooth[2] = {-0.1 * s, 0, 0.1 * c, 0};
        tooth[3] = {0.95 * c, 0, 0.95 * s, 1};
        grid.operand(Cube<double>{}, tooth);
    }
    grid.operand(Cylinder<double>{}, upright({0.25, 0.25, 0.5}, {0, 0, 0}));
    return grid.fill(first, teeth + 1);
}

} // namespace rayscope::bench
