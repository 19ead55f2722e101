#include "src/base/parse_hash.h"

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <system_error>

namespace tumble {

std::optional<Hash128> parse_hash(std::string_view digits) {
  constexpr std::size_t kWordDigits = 16;
  if (digits.size() != 2 * kWordDigits) return std::nullopt;
  const auto parse = [&](std::size_t from, std::uint64_t& word) {
    const char* end = digits.data() + from + kWordDigits;
    const auto [stop, error] = std::from_chars(digits.data() + from, end, word, 16);
    return error == std::errc() && stop == end;
  };
  Hash128 hash;
  if (!parse(0, hash.high) || !parse(kWordDigits, hash.low)) return std::nullopt;
  return hash;
}

}  // namespace tumble
