#pragma once
// OBJ files, looked through before they are read.

#include <string>
#include <string_view>

namespace rayscope {

/// tinyobjloader takes what is no number for 0. This throws InputError at the first such word in a line of a vertex, a
/// normal or a face, and where a face has too few or too many corners.
void check_obj(std::string_view text, const std::string& file);

} // namespace rayscope
