#include "tools/output/text.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "src/base/check.h"
#include "src/base/schema_name.h"
#include "src/base/utf8.h"

namespace tumble::tools {
namespace {

/// JSON escapes control characters below U+0020 itself. Others that no reader sees as they are would drive a terminal
/// all the same, and are escaped here, so that they come through as they were.
std::string escape_harmful(const std::string& json) {
  std::string out;
  out.reserve(json.size());
  for (std::size_t at = 0; at < json.size();) {
    const auto [code, length] = utf8_at(json, at);
    SIM_CHECK(length > 0, at);
    if (is_shown_as_read(code)) {
      out.append(json, at, length);
    } else {
      constexpr std::string_view kDigits = "0123456789abcdef";
      out += "\\u";
      for (const unsigned shift : {12U, 8U, 4U, 0U}) out += kDigits[code >> shift & 15U];
    }
    at += length;
  }
  return out;
}

}  // namespace

void print_json(std::string_view command, const Json& json) {
  const auto named = [&](const Json& report) {
    Json out = {{"schema", schema_name(command)}};
    out.update(report);
    return out;
  };
  Json out = json.is_array() ? Json::array() : named(json);
  if (json.is_array()) {
    for (const Json& item : json) out.push_back(named(item));
  }
  std::cout << escape_harmful(out.dump(2, ' ', false, Json::error_handler_t::replace)) << '\n';
}

Json number_json(double value) { return std::isfinite(value) ? Json(value) : Json(exact_bits(value)); }

std::optional<double> number_of(const Json& json) {
  if (json.is_number()) return json.get<double>();
  return json.is_string() ? parse_exact(json.get<std::string>()) : std::nullopt;
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

TableColumns::TableColumns(std::vector<std::string> header) {
  for (std::string& name : header) {
    right_.push_back(name.starts_with('>'));
    if (right_.back()) name.erase(0, 1);
    name = printable(name);
  }
  header_ = std::move(header);
  widths_.resize(header_.size());
  fit(header_);
}

void TableColumns::fit(const std::vector<std::string>& row) {
  SIM_CHECK(row.size() <= widths_.size(), row.size(), widths_.size());
  for (std::size_t k = 0; k < row.size(); ++k) widths_[k] = std::max(widths_[k], columns(row[k]));
}

void TableColumns::print(const std::vector<std::string>& row) const {
  std::string line;
  for (std::size_t k = 0; k < row.size(); ++k) {
    if (k > 0) line += "  ";
    line += right_[k] ? padded_left(row[k], widths_[k]) : padded(row[k], widths_[k]);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  std::cout << line << '\n';
}

void Table::add(std::vector<std::string> row) {
  for (std::string& cell : row) cell = printable(cell);
  columns_.fit(row);
  rows_.push_back(std::move(row));
}

void Table::print() const {
  columns_.print_header();
  for (const auto& row : rows_) columns_.print(row);
}

void LongTable::add(std::vector<std::string> row) {
  for (std::string& cell : row) cell = printable(cell);
  if (again_) {
    columns_.print(row);
    return;
  }
  columns_.fit(row);
  if (++rows_ <= kKeptMax) kept_.push_back(std::move(row));
  if (rows_ == kKeptMax + 1) kept_ = {};
}

bool LongTable::print() {
  columns_.print_header();
  for (const auto& row : kept_) columns_.print(row);
  again_ = rows_ > kKeptMax;
  return !again_;
}

}  // namespace tumble::tools
