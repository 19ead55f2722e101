#include "src/base/text.h"

#define FMT_HEADER_ONLY 1  // cross builds have headers alone
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

#include "src/base/utf8.h"

namespace tumble {
namespace {

constexpr std::size_t kShownLength = 60;    // bytes of a text in a message
constexpr std::size_t kWordLengthMax = 40;  // longer words are no slips of a key

// Shortest digits come from the standard library: {fmt} chooses other limits between fixed and scientific notation.
template <class... Format>
std::string shortest(double value, Format... format) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format...);
  return {buffer.data(), end.ptr};
}

// Levenshtein's distance, row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

/// The run of digits that begins at a place; empty: no digit is there.
std::string_view digits_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && text[end] >= '0' && text[end] <= '9') ++end;
  return text.substr(at, end - at);
}

std::string_view without_zeros(std::string_view digits) {
  return digits.substr(std::min(digits.find_first_not_of('0'), digits.size()));
}

}  // namespace

std::string exact(double value) { return shortest(value); }

std::string exact_bits(double value) {
  if (std::isfinite(value)) return exact(value);
  const char* word = std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  return fmt::format("{}(0x{:016x})", word, std::bit_cast<std::uint64_t>(value));
}

std::optional<double> parse_exact(std::string_view text) {
  constexpr int kHex = 16;
  const std::size_t open = text.find("(0x");
  if (open != std::string_view::npos) {
    std::uint64_t bits = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + open + 3, end, bits, kHex);
    const double value = std::bit_cast<double>(bits);
    const bool whole = error == std::errc() && stop + 1 == end && *stop == ')';
    return whole && exact_bits(value) == text ? std::optional(value) : std::nullopt;
  }
  // std::from_chars reads any word in the brackets and drops it. Windows prints "-nan(ind)" for the NaN of 0 / 0.
  if (text.ends_with(')') && text != "nan(ind)" && text != "-nan(ind)") return std::nullopt;
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && stop == text.data() + text.size() && !text.empty();
  return whole ? std::optional(value) : std::nullopt;
}

std::string number_text(double value) {
  const double size = std::fabs(value);
  const bool plain = size == 0 || (size >= 1e-5 && size < 1e9);
  return plain ? shortest(value, std::chars_format::fixed) : shortest(value);
}

std::string fixed(double value, int digits) { return fmt::format("{:.{}f}", value, digits); }

std::string significant(double value, int digits) { return fmt::format("{:.{}g}", value == 0 ? 0.0 : value, digits); }

std::string rounded(double value, std::string_view unit) {
  return unit.empty() ? significant(value, 4) : fmt::format("{} {}", significant(value, 4), unit);
}

std::string hex_digits(std::string_view bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const char c : bytes) {
    const auto byte = static_cast<unsigned char>(c);
    (text += kDigits[byte >> 4U]) += kDigits[byte & 15U];
  }
  return text;
}

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 10'000) return count_text(bytes, "byte");
  double value = static_cast<double>(bytes) / 1000;
  for (const char* unit : {"kB", "MB", "GB"}) {
    if (value < 1000) return fmt::format("{:.{}f} {}", value, value < 100 ? 1 : 0, unit);
    value /= 1000;
  }
  return fmt::format("{:.1f} TB", value);
}

std::string count_text(std::uint64_t n, const char* one) {
  std::string noun = one;
  if (n != 1) {
    if (noun.ends_with('y')) noun.replace(noun.size() - 1, 1, "ie");
    noun += 's';
  }
  return fmt::format("{} {}", n, noun);
}

std::string seconds_text(double seconds) {
  if (seconds > 0 && seconds < 0.0000995) return fmt::format("{:.1f} µs", seconds * 1e6);
  if (seconds < 0.0995) return fmt::format("{:.1f} ms", seconds * 1000);
  return fmt::format("{:.{}f} s", seconds, seconds < 100 ? 2 : 0);
}

std::string found_wanted(std::string_view found, std::string_view wanted) {
  return fmt::format("found {}, wanted {}", found, wanted);
}

std::string printable(std::string_view text) {
  const auto is_plain = [](char c) { return c >= ' ' && c <= '~'; };
  if (std::ranges::all_of(text, is_plain)) return std::string(text);  // as almost all text is
  std::string out;
  out.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const auto [code, length] = utf8_at(text, at);
    const bool is_good = length > 0 && code >= 0x20 && is_shown_as_read(code);
    out += is_good ? text.substr(at, length) : "?";
    at += std::max<std::size_t>(length, 1);
  }
  return out;
}

std::string shortened(std::string_view text) {
  std::size_t end = 0;  // behind whole characters
  while (end < text.size()) {
    const std::size_t length = std::max<std::size_t>(utf8_at(text, end).length, 1);
    if (end + length > kShownLength) break;
    end += length;
  }
  return printable(text.substr(0, end)) + (end < text.size() ? "…" : "");
}

std::string in_quotes(std::string_view text) { return fmt::format("\"{}\"", shortened(text)); }

std::string shell_quoted(std::string_view word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-./+=:,@") == std::string_view::npos;
  if (plain) return std::string(word);
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::string list_text(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::string joined(const std::vector<std::string>& words, std::string_view between) {
  std::string out;
  for (const std::string& word : words) {
    if (!out.empty()) out += between;
    out += word;
  }
  return out;
}

std::string replaced(std::string text, std::string_view what, std::string_view with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& candidates) {
  if (word.size() > kWordLengthMax) return {};
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

bool natural_less(std::string_view a, std::string_view b) {
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    const std::string_view in_a = digits_at(a, i), in_b = digits_at(b, j);
    if (in_a.empty() || in_b.empty()) {
      if (a[i] != b[j]) return static_cast<unsigned char>(a[i]) < static_cast<unsigned char>(b[j]);
      ++i;
      ++j;
      continue;
    }
    const std::string_view one = without_zeros(in_a), other = without_zeros(in_b);
    if (one.size() != other.size()) return one.size() < other.size();
    if (one != other) return one < other;
    i += in_a.size();
    j += in_b.size();
  }
  const bool a_ends = i == a.size(), b_ends = j == b.size();
  return a_ends != b_ends ? a_ends : a < b;
}

// Bytes that do not continue a UTF-8 character.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xc0') != '\x80'; }));
}

std::string padded(std::string_view text, std::size_t width) {
  const std::size_t has = columns(text);
  return std::string(text) + std::string(width > has ? width - has : 0, ' ');
}

std::string padded_left(std::string_view text, std::size_t width) {
  const std::size_t has = columns(text);
  return std::string(width > has ? width - has : 0, ' ') + std::string(text);
}

}  // namespace tumble
