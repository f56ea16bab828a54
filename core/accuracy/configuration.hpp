#pragma once
// What a render can be asked to spend more or less on: the axes of accuracy, and the points on them.

#include "core/math/numbers.hpp"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rayscope {

struct Configuration {
    NumbersChoice numbers;
    int max_depth = 8;
    double min_weight = 0.001;

    friend bool operator==(const Configuration&, const Configuration&) = default;
};

/// "double stable, depth 8, weight 0.001"
[[nodiscard]] std::string name_of(const Configuration& configuration);

/// One row of the table of axes. A new kind of effort is a new row.
struct Axis {
    std::string_view name;
    std::string_view expected;       ///< what a value looks like, for messages
    std::vector<std::string> values; ///< where nobody says which
    /// Sets the value in the configuration; false if the text is none of this axis.
    bool (*set)(Configuration&, std::string_view text);
};
[[nodiscard]] const std::vector<Axis>& axes();

/// The configurations that a text asks for; `base`, the scene's own in double stable, is the first.
///
///   default             each axis alone, and both methods in each scalar type
///   full                every combination of all axes' values
///   depth, scalar …     that axis alone
///   float,textbook      one configuration: the base with these values; depth=3 and weight=0.01 are values, too
///
/// Several of these stand with a slash between them: "scalar/float,textbook,depth=3".
/// Throws std::invalid_argument that says which word is wrong and what was expected.
[[nodiscard]] std::vector<Configuration> configurations(std::string_view text, const Configuration& base);

/// One configuration, as between two slashes above.
[[nodiscard]] Configuration configuration(std::string_view text, const Configuration& base);

} // namespace rayscope
