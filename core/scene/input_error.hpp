#pragma once
// The one exception that wrong input throws.

#include <stdexcept>
#include <string>

namespace rayscope {

/// Where in a file something stands, from 1; 0 = not known.
struct Place {
    int line = 0;
    int column = 0;
};

/// A file or an argument that is wrong: where, and what was expected instead. what() is
/// "file:line:column: message".
class InputError : public std::runtime_error {
public:
    InputError(std::string file, Place place, const std::string& message);

    std::string file;
    Place place;
    std::string message;
};

} // namespace rayscope
