#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string_view>

/// Checks of what the code relies on. A check that fails is a mistake of ours, never of the user: the process prints
/// file, line, condition and the values that were found, and ends at once with exit status 4. The log that is being
/// written keeps its complete chunks.
///
/// SIM_CHECK(i < size, i, size);    on in every build
/// SIM_DCHECK(is_sorted(pairs));    in builds without NDEBUG and in those with sanitizers; for what costs too much
namespace tumble::base {

/// A value that a failed check shows: a number or a text.
struct CheckValue {
  enum class Kind : std::uint8_t { kSigned, kUnsigned, kReal, kText };

  CheckValue(std::signed_integral auto value) : kind(Kind::kSigned), whole(value) {}
  CheckValue(std::unsigned_integral auto value) : kind(Kind::kUnsigned), natural(value) {}
  CheckValue(double value) : kind(Kind::kReal), real(value) {}
  CheckValue(std::string_view value) : kind(Kind::kText), text(value) {}

  Kind kind;
  std::int64_t whole = 0;
  std::uint64_t natural = 0;
  double real = 0;
  std::string_view text;
};

/// Prints "FILE:LINE: internal check failed: CONDITION; found NAMES = VALUES" to stderr and ends the process.
[[noreturn]] void check_failed(const char* file, int line, const char* condition, const char* names,
                               std::initializer_list<CheckValue> values);

}  // namespace tumble::base

#define SIM_CHECK(condition, ...) \
  ((condition) ? void() : ::tumble::base::check_failed(__FILE__, __LINE__, #condition, #__VA_ARGS__, {__VA_ARGS__}))

#if !defined(NDEBUG) || defined(TUMBLE_DCHECKS)
#define SIM_DCHECK(...) SIM_CHECK(__VA_ARGS__)
#else
#define SIM_DCHECK(...) void()
#endif
