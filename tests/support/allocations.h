#pragma once

#include <cstdint>

namespace tumble::test {

/// Blocks of memory asked for so far, by any thread, with new, malloc, calloc, realloc or aligned_alloc. For a test
/// program that has this file's source, linked with --wrap for the latter four (tests/CMakeLists.txt).
std::uint64_t allocations();

/// Bytes asked for with new and not given back.
std::int64_t bytes_held();

}  // namespace tumble::test
