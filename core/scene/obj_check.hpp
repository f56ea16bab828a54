#pragma once
// OBJ files, looked through before they are read.

#include "core/math/vec.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

/// What the lines `v` and `vn` say, in their order, each number rounded once. tinyobjloader's own are off by an ulp or so:
/// corners at one place would part.
struct ObjNumbers {
    std::vector<Vec3d> positions, normals;
};

/// tinyobjloader takes what is no number for 0. This throws InputError at the first such word in a line of a vertex, a
/// normal or a face, and where a face has too few or too many corners.
[[nodiscard]] ObjNumbers check_obj(std::string_view text, const std::string& file);

} // namespace rayscope
