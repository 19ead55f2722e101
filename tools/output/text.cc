#include "tools/output/text.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "src/base/check.h"

namespace tumble::tools {
namespace {

/// JSON escapes a control character below U+0020 itself. Others, which would drive a terminal all the same, are escaped
/// here, so that they come through as they were: U+007F to U+009F, and those that turn the direction of writing.
std::string escape_harmful(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  const auto byte = [&](std::size_t i) { return i < json.size() ? static_cast<unsigned char>(json[i]) : 0U; };
  for (std::size_t at = 0; at < json.size();) {
    const unsigned first = byte(at), second = byte(at + 1), third = byte(at + 2);
    std::size_t length = 0;
    unsigned code = 0;
    if (first == 0x7FU) {
      length = 1;
      code = first;
    } else if (first == 0xC2U && second >= 0x80U && second <= 0x9FU) {
      length = 2;
      code = second;
    } else if (first == 0xE2U && second == 0x80U &&
               (third == 0x8EU || third == 0x8FU || (third >= 0xAAU && third <= 0xAEU))) {
      length = 3;
      code = 0x2000U + (third & 0x3FU);
    } else if (first == 0xE2U && second == 0x81U && third >= 0xA6U && third <= 0xA9U) {
      length = 3;
      code = 0x2040U + (third & 0x3FU);
    }
    if (length == 0) {
      out += json[at++];
      continue;
    }
    constexpr std::string_view kDigits = "0123456789abcdef";
    out += "\\u";
    for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kDigits[code >> shift & 15U];
    at += length;
  }
  return out;
}

}  // namespace

void print_json(const Json& json) {
  std::cout << escape_harmful(json.dump(2, ' ', false, Json::error_handler_t::replace)) << '\n';
}

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(exact_bits(value)); }

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
    SIM_CHECK(row.size() <= widths.size(), row.size(), widths.size());
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
