#pragma once
// A guard in front of the TOML library (toml++ 3.3), which can't take every text.

#include "core/scene/source_text.hpp"

namespace rayscope {

/// The longest dotted key that a scene may have, counted in dots.
inline constexpr int most_dots = 8;
/// How deep lists and tables may be nested in a value.
inline constexpr std::size_t most_brackets = 32;

/// Fails where the library might not:
/// - at a key (or a table's header) with more dots, and at deeper brackets. The library reads and frees nested
///   tables by recursion, limits only brackets, and those to 256: a.a.a… with 10⁵ dots would overflow the call stack;
/// - at a character beyond ASCII outside strings and comments, which TOML forbids there, or right after a backslash
///   and blanks. For some of them the library reaches a place that it takes for unreachable; so an odd quote,
///   bracket or = that could make it see such a character within what looks like a string is refused too.
void guard_toml_parser(const SourceText& source);

} // namespace rayscope
