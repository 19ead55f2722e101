#include "tools/output/text.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "src/base/check.h"

namespace tumble::tools {

void print_json(const Json& json) { std::cout << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n'; }

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
