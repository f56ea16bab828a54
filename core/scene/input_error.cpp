#include "core/scene/input_error.hpp"

#include <fmt/format.h>

#include <utility>

namespace rayscope {
namespace {

std::string full_text(const std::string& file, Place place, const std::string& message) {
    if (place.line == 0) return fmt::format("{}: {}", file, message);
    if (place.column == 0) return fmt::format("{}:{}: {}", file, place.line, message);
    return fmt::format("{}:{}:{}: {}", file, place.line, place.column, message);
}

} // namespace

InputError::InputError(std::string in_file, Place at, const std::string& what_is_wrong)
    : std::runtime_error(full_text(in_file, at, what_is_wrong)),
      file(std::move(in_file)),
      place(at),
      message(what_is_wrong) {}

} // namespace rayscope
