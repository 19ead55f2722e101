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

#include <toml++/toml.h>
