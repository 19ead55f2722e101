#include "src/base/utf8.h"

#include <algorithm>
#include <array>

namespace tumble {
namespace {

std::uint32_t byte_of(char c) { return static_cast<unsigned char>(c); }

}  // namespace

std::size_t utf8_length(char first) {
  const std::uint32_t byte = byte_of(first);
  if (byte < 0x80U) return 1;
  if (byte < 0xC2U || byte > 0xF4U) return 0;
  return byte >= 0xF0U ? 4 : byte >= 0xE0U ? 3 : 2;
}

Character utf8_at(std::string_view text, std::size_t at) {
  if (at >= text.size()) return {};
  const std::size_t length = utf8_length(text[at]);
  if (length == 1) return {byte_of(text[at]), 1};
  if (length == 0 || length > text.size() - at) return {};
  std::uint32_t code = byte_of(text[at]) & (0xFFU >> (length + 1));
  for (std::size_t i = at + 1; i < at + length; ++i) {
    if ((byte_of(text[i]) & 0xC0U) != 0x80U) return {};
    code = code << 6U | (byte_of(text[i]) & 0x3FU);
  }
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};  // by length
  const bool is_surrogate = code >= 0xD800U && code <= 0xDFFFU;
  if (code < kLeast[length] || code > 0x10FFFFU || is_surrogate) return {};
  return {code, length};
}

std::string valid_text(std::string_view text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = utf8_at(text, at).length;
    out += length == 0 ? "\uFFFD" : text.substr(at, length);
    at += std::max<std::size_t>(length, 1);
  }
  return out;
}

bool is_shown_as_read(std::uint32_t code) {
  if (code < 0x20U) return code == '\n' || code == '\t';
  const bool is_control = code >= 0x7FU && code <= 0x9FU;
  const bool turns_direction = (code >= 0x202AU && code <= 0x202EU) || (code >= 0x2066U && code <= 0x2069U) ||
                               code == 0x200EU || code == 0x200FU;
  return !is_control && !turns_direction && code != 0xFFFEU && code != 0xFFFFU;
}

}  // namespace tumble
