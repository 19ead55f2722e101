#include "replay/arrays/pair_cell.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::string_view kDigits = "0123456789abcdef";

bool needs_escape(unsigned char c) { return c <= 0x20 || c == ',' || c == '%' || c == '"' || c == 0x7f; }
bool parts_cells(unsigned char c) { return c < 0x20 || c == ',' || c == '%' || c == 0x7f; }

void append_escape(unsigned char byte, std::string& out) {
  out += '%';
  out += kDigits[byte >> 4U];
  out += kDigits[byte & 15U];
}

}  // namespace

std::optional<std::vector<PairCell>> split_pair_cell(std::string_view cell) {
  std::vector<PairCell> entries;
  while (!cell.empty()) {
    const std::size_t end = std::min(cell.find(' '), cell.size());
    const std::string_view entry = cell.substr(0, end);
    cell.remove_prefix(std::min(end + 1, cell.size()));
    if (entry.empty()) continue;
    PairCell found;
    const char* stop = entry.data() + entry.size();
    const auto [rest, error] = std::from_chars(entry.data(), stop, found.other);
    if (error != std::errc() || rest == stop || *rest != '=') return std::nullopt;
    found.value = entry.substr(static_cast<std::size_t>(rest - entry.data()) + 1);
    entries.push_back(found);
  }
  return entries;
}

std::string escaped_cell(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (!needs_escape(byte)) {
      out += c;
      continue;
    }
    append_escape(byte, out);
  }
  return out;
}

std::string text_cell(std::string_view text) {
  if (text.empty()) return "%";
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    const bool at_end = text[i] == ' ' && (i == 0 || i + 1 == text.size());
    if (parts_cells(byte) || at_end) {
      append_escape(byte, out);
    } else {
      out += text[i];
    }
  }
  return out;
}

std::string text_in_cell(std::string_view cell) { return cell == "%" ? std::string() : unescaped_cell(cell); }

std::string unescaped_cell(std::string_view text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    unsigned byte = 0;
    const bool is_escape = text[i] == '%' && i + 2 < text.size();
    if (is_escape) {
      const auto [rest, error] = std::from_chars(text.data() + i + 1, text.data() + i + 3, byte, 16);
      if (error == std::errc() && rest == text.data() + i + 3) {
        out += static_cast<char>(byte);
        i += 2;
        continue;
      }
    }
    out += text[i];
  }
  return out;
}

std::string number_cell(double number) {
  constexpr double kUsualNan = std::numeric_limits<double>::quiet_NaN();
  const bool plain =
      !std::isnan(number) || std::bit_cast<std::uint64_t>(number) == std::bit_cast<std::uint64_t>(kUsualNan);
  return plain ? exact(number) : exact_bits(number);
}

}  // namespace tumble::replay
