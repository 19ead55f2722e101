#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/base/text.h"

/// Prints results: for people, aligned and with units; for programs, exact.
namespace tumble::tools {

/// Keys stay in the order in which they are set.
using Json = nlohmann::ordered_json;

/// Prints what a command reports as JSON, and a newline, to stdout. Its first member, or that of each item of a list,
/// is `schema`, the name of the command's schema. Numbers read back to the same bits; text that is not UTF-8 (a log may
/// hold any) gets replacement characters.
void print_json(std::string_view command, const Json& json);

/// A number, or, where JSON has none for it, the text of exact_bits(): "nan(0x7ff8000000000000)".
Json number_json(double value);

/// The number that number_json() wrote; none for other values.
std::optional<double> number_of(const Json& json);

/// Lines of "label  value", values aligned. Text of a file stays in its line: it is printed as printable() has it.
class Listing {
 public:
  void add(std::string_view label, std::string_view value) { lines_.emplace_back(printable(label), printable(value)); }
  /// An empty line, and `title` on a line of its own if there is one.
  void section(std::string_view title) { lines_.emplace_back(title.empty() ? "" : "\n" + printable(title), ""); }
  void print() const;

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// The header of a table and the widths of its columns, which are as wide as they need to be. Cells are printed as
/// printable() has them.
class TableColumns {
 public:
  /// A name that begins with '>' makes a column of numbers, aligned on the right.
  explicit TableColumns(std::vector<std::string> header);
  /// Makes the columns wide enough for a row.
  void fit(const std::vector<std::string>& row);
  void print_header() const { print(header_); }
  void print(const std::vector<std::string>& row) const;

 private:
  std::vector<std::string> header_;
  std::vector<bool> right_;
  std::vector<std::size_t> widths_;
};

/// A table of rows that are all kept.
class Table {
 public:
  /// As TableColumns.
  explicit Table(std::vector<std::string> header) : columns_(std::move(header)) {}
  void add(std::vector<std::string> row);
  void print() const;

 private:
  TableColumns columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// A table of any number of rows, in bounded memory. Its rows are added once; where they are too many to be kept, they
/// have to be added a second time, in the same order, and are printed as they come.
class LongTable {
 public:
  static constexpr std::size_t kKeptMax = 20'000;  ///< about 10 MB of a table with 16 columns

  explicit LongTable(std::vector<std::string> header) : columns_(std::move(header)) {}
  void add(std::vector<std::string> row);
  /// After all rows were added once. True: the table is printed. False: its header is, and the rows have to come again.
  bool print();

 private:
  TableColumns columns_;
  std::vector<std::vector<std::string>> kept_;  // all rows, or none
  std::size_t rows_ = 0;
  bool again_ = false;  // rows come the second time
};

}  // namespace tumble::tools
