#pragma once
// What a reader says of a wrong scene.

#include "core/scene/read_toml.hpp"

#include <string>
#include <string_view>

namespace rayscope {

/// The whole message for a text in a file s.toml.
inline std::string error_of(std::string_view text) {
    try {
        (void)parse_toml(text, "s.toml");
        return "no error";
    } catch (const InputError& error) {
        return error.what();
    }
}

} // namespace rayscope
