#include "core/math/transform.hpp"
#include "core/scene/toml_sections.hpp"

#include <fmt/format.h>

#include <numbers>

namespace rayscope {
namespace {

struct Turn {
    double cosine = 1, sine = 0;
};

// Quarter turns are exact: a cube turned by 90° keeps its faces on the axes.
Turn turn_by(double degrees) {
    const double angle = std::remainder(degrees, 360.0);
    if (angle == 0) return {1, 0};
    if (angle == 90) return {0, 1};
    if (angle == -90) return {0, -1};
    if (std::abs(angle) == 180) return {-1, 0};
    const double radians = angle * (std::numbers::pi / 180);
    return {std::cos(radians), std::sin(radians)};
}

// Rodrigues: R = cos·1 + sin·[a]× + (1 − cos)·a aᵀ for the unit axis a; right-handed.
Mat4d rotation(const Vec3d& axis, double degrees) {
    const Turn turn = turn_by(degrees);
    const Vec3d a = normalized(axis);
    Mat4d matrix{1};
    for (int column = 0; column < 3; ++column) {
        Vec3d unit{0};
        unit[column] = 1;
        const Vec3d image =
            turn.cosine * unit + turn.sine * cross(a, unit) + (1 - turn.cosine) * a[column] * a;
        for (int row = 0; row < 3; ++row) matrix[column][row] = image[row];
    }
    return matrix;
}

Mat4d scaling(const Vec3d& factors) {
    Mat4d matrix{1};
    for (int i = 0; i < 3; ++i) matrix[i][i] = factors[i];
    return matrix;
}

Mat4d read_rotation(const TomlTable& table, const TomlValue& axis) {
    const Vec3d direction = axis.vector();
    if (length(direction) == 0) axis.fail("'rotate': the axis has length zero");
    return rotation(direction,
                    table.require("angle", axis.place(), "{rotate = [0, 0, 1], angle = 30}").number());
}

Mat4d read_translation(const TomlValue& value) {
    const Vec3d offset = value.vector();
    Mat4d matrix{1};
    for (int row = 0; row < 3; ++row) matrix[3][row] = offset[row];
    return matrix;
}

// x' = x + xy·y + xz·z, and so on.
Mat4d read_shear(const TomlValue& value) {
    const auto parts = value.list(6, "[xy, xz, yx, yz, zx, zy]");
    Mat4d matrix{1};
    std::size_t next = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            if (row != column) matrix[column][row] = parts[next++].number();
    return matrix;
}

Mat4d read_mirror(const TomlValue& value) {
    Vec3d factors{1};
    factors[int(value.choice({"x", "y", "z"}))] = -1;
    return scaling(factors);
}

Mat4d read_matrix(const TomlValue& value) {
    Mat4d matrix{1};
    const auto rows = value.list(4, "four rows of four numbers");
    for (int row = 0; row < 4; ++row) {
        const auto parts = rows[std::size_t(row)].list(4, "four numbers in each row");
        for (int column = 0; column < 4; ++column) matrix[column][row] = parts[std::size_t(column)].number();
    }
    for (int column = 0; column < 4; ++column)
        if (matrix[column][3] != (column == 3 ? 1 : 0))
            rows[3].fail(
                "'matrix': expected [0, 0, 0, 1] as the last row, since only affine maps keep rays straight "
                "and their t");
    return matrix;
}

Mat4d read_kind(const TomlTable& table, const TomlEntry& entry) {
    const TomlValue& value = entry.value;
    if (entry.key == "scale") return scaling(value.is_number() ? Vec3d{value.number()} : value.vector());
    if (entry.key == "rotate") return read_rotation(table, value);
    if (entry.key == "rotate_x") return rotation({1, 0, 0}, value.number());
    if (entry.key == "rotate_y") return rotation({0, 1, 0}, value.number());
    if (entry.key == "rotate_z") return rotation({0, 0, 1}, value.number());
    if (entry.key == "translate") return read_translation(value);
    if (entry.key == "shear") return read_shear(value);
    if (entry.key == "mirror") return read_mirror(value);
    return read_matrix(value);
}

Mat4d read_step(const TomlValue& step) {
    const TomlTable table = step.table();
    table.allow_only("a transform", {"scale", "rotate", "angle", "rotate_x", "rotate_y", "rotate_z",
                                     "translate", "shear", "mirror", "matrix"});
    std::vector<TomlEntry> kinds;
    for (const TomlEntry& entry : table.entries())
        if (entry.key != "angle") kinds.push_back(entry);
    if (kinds.empty()) step.fail("this transform does nothing, expected for example {translate = [1, 2, 3]}");
    if (kinds.size() > 1)
        step.source().fail(kinds[1].place,
                           fmt::format("one transform holds one step, and this one has '{}' already: "
                                       "write {{{} = …}}, {{{} = …}}, the first to be applied first",
                                       kinds[0].key, kinds[0].key, kinds[1].key));
    if (table.has("angle") && kinds[0].key != "rotate")
        step.source().fail(table.place_of("angle"), "'angle' belongs to 'rotate' = [x, y, z], the axis");
    const Mat4d matrix = read_kind(table, kinds[0]);
    if (!is_invertible(matrix)) kinds[0].value.fail("this transform is singular: it flattens space");
    return matrix;
}

bool in_range(const Mat4d& matrix) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!(std::abs(matrix[column][row]) <= largest_number)) return false;
    return true;
}

} // namespace

Mat4d read_transform(const TomlValue& value) {
    Mat4d matrix{1};
    for (const TomlValue& step : value.list()) {
        matrix = read_step(step) * matrix;
        if (!in_range(matrix) || !is_invertible(matrix))
            step.fail("up to this one, the transforms together leave the range of numbers");
    }
    return matrix;
}

} // namespace rayscope
