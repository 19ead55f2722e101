#pragma once

// toml++ as the scene reader wants it; the only place that includes it. Errors are values; numbers are read by
// std::from_chars, which no locale can change; nesting is bounded far above what a scene needs (three levels), because
// a table's destructor recurses. A file that also includes toml++ in another way would have two parsers in one program:
// include this header instead.
#ifndef TOML_HEADER_ONLY
#define TOML_HEADER_ONLY 1
#endif
#define TOML_EXCEPTIONS 0
#define TOML_FLOAT_CHARCONV 1
#define TOML_MAX_NESTED_VALUES 16

#include <toml++/impl/preprocessor.h>

namespace tumble::scenes {

/// Malformed text such as "[&" breaks what the parser of version 3.3 asserts about it: an abort in a debug build, and
/// under clang an assumption to optimise by, which is worse. Here it ends the parse: parse_toml() catches it.
struct BrokenAssertion {};

constexpr void toml_assert(bool holds) {
  if (!holds) throw BrokenAssertion();
}

}  // namespace tumble::scenes

#undef TOML_ASSERT
#undef TOML_ASSERT_ASSUME
#define TOML_ASSERT(expr) ::tumble::scenes::toml_assert(static_cast<bool>(expr))
#define TOML_ASSERT_ASSUME(expr) TOML_ASSERT(expr)

#include <toml++/toml.h>
