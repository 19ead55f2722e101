#include "tools/arguments/numbers.h"

#include <charconv>

namespace tumble::tools {
namespace {

template <class T>
std::optional<T> parse(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::uint64_t> parse_whole(const std::string& text) { return parse<std::uint64_t>(text); }
std::optional<double> parse_number(const std::string& text) { return parse<double>(text); }

}  // namespace tumble::tools
