#include "tools/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <iostream>

namespace tumble::tools {
namespace {

// Columns that a text takes: bytes that do not continue a UTF-8 character.
std::size_t columns(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & '\xc0') != '\x80'; }));
}

std::string formatted(const char* format, double value) {
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), format, value);
  return buffer.data();
}

}  // namespace

void print_json(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n'; }

std::string exact(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), end};
}

std::string rounded(double value, std::string_view unit) {
  const std::string number = value == 0 ? "0" : formatted("%.4g", value);
  return unit.empty() ? number : number + ' ' + std::string(unit);
}

std::string bytes_text(std::uint64_t bytes) {
  if (bytes < 10'000) return count_text(bytes, "byte");
  double value = static_cast<double>(bytes) / 1000;
  for (const char* unit : {"kB", "MB", "GB"}) {
    if (value < 1000) return formatted(value < 100 ? "%.1f " : "%.0f ", value) + unit;
    value /= 1000;
  }
  return formatted("%.1f TB", value);
}

std::string count_text(std::uint64_t n, const char* one) {
  std::string noun = one;
  if (n != 1) {
    if (noun.ends_with('y')) noun.replace(noun.size() - 1, 1, "ie");
    noun += 's';
  }
  return std::to_string(n) + ' ' + noun;
}

std::string seconds_text(double seconds) {
  if (seconds < 0.0995) return formatted("%.1f ms", seconds * 1000);
  return formatted(seconds < 100 ? "%.2f s" : "%.0f s", seconds);
}

std::string printable(std::string_view text) {
  std::string out(text);
  std::ranges::replace_if(
      out, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return out;
}

std::string padded(std::string_view text, std::size_t width) {
  const std::size_t has = columns(text);
  return std::string(text) + std::string(width > has ? width - has : 0, ' ');
}

std::string padded_left(std::string_view text, std::size_t width) {
  const std::size_t has = columns(text);
  return std::string(width > has ? width - has : 0, ' ') + std::string(text);
}

void Listing::print() const {
  std::size_t width = 0;
  for (const auto& [label, value] : lines_) {
    if (!value.empty()) width = std::max(width, columns(label));
  }
  for (const auto& [label, value] : lines_) {
    std::cout << (value.empty() ? label : padded(label, width + 2) + value) << '\n';
  }
}

Table::Table(std::vector<std::string> header) {
  for (std::string& name : header) {
    right_.push_back(name.starts_with('>'));
    if (right_.back()) name.erase(0, 1);
  }
  rows_.push_back(std::move(header));
}

void Table::print() const {
  std::vector<std::size_t> widths(right_.size(), 0);
  for (const auto& row : rows_) {
    for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], columns(row[k]));
  }
  for (const auto& row : rows_) {
    std::string line;
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) line += "  ";
      line += right_[k] ? padded_left(row[k], widths[k]) : padded(row[k], widths[k]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::cout << line << '\n';
  }
}

}  // namespace tumble::tools
