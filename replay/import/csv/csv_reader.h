#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::replay {

/// A line "# key: value" before the table.
struct CsvSetting {
  std::string key;
  std::string value;
  std::uint64_t line = 0;
};

/// Reads a table of numbers: lines "# key: value", a line with the names of the columns, then one row per line. Commas
/// separate the cells; quotes are not used. Behind a line "# escapes: percent" all names and cells are as text_cell()
/// writes them. The reader ignores blanks around cells, empty lines, and lines below the
/// names that begin with #. Lines may end in CR LF; the last row ends so too. Errors (kBadInput) begin with
/// "<name>:<line>:<column>: "; line and column count from 1, the column in bytes. Those of a table that was made of
/// arrays begin with "<name>: step 3, body 2: ".
class CsvReader {
 public:
  /// Reads up to the names of the columns. `text` must outlive the reader.
  static Result<CsvReader> open(std::string_view text, std::string name);

  [[nodiscard]] const std::vector<CsvSetting>& settings() const { return settings_; }
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view column) const;
  /// Gives a column another name; false where no column has the old one.
  bool rename(std::string_view column, const std::string& name);
  [[nodiscard]] const std::string& name() const { return name_; }  ///< of the table

  /// The text before the line with the names of the columns, and the text behind it. Before the first next().
  [[nodiscard]] std::string_view head() const {
    return text_.substr(0, static_cast<std::size_t>(current_.data() - text_.data()));
  }
  [[nodiscard]] std::string_view rows() const { return text_.substr(std::min(begin_, text_.size())); }
  /// Whether names and cells are as text_cell() writes them.
  [[nodiscard]] bool escaped() const { return escaped_; }

  /// Moves to the next row; false at the end. Errors: the row has not as many cells as columns, or is the end of the
  /// text without a line end, because a number that was cut may still be a number.
  Result<bool> next();
  /// Lines "# key: value" that the last next() passed over.
  [[nodiscard]] const std::vector<CsvSetting>& passed_over() const { return passed_over_; }

  // A cell of the row, by the number of its column. Errors: no number, or one that the type does not hold.
  /// Also texts of exact_bits(), to the bit.
  [[nodiscard]] Result<double> number(std::size_t column) const;
  /// Rounded once, to float, which gives the value that a program with floats printed.
  [[nodiscard]] Result<double> single(std::size_t column) const;
  [[nodiscard]] Result<std::uint64_t> whole(std::size_t column) const;
  [[nodiscard]] Result<bool> flag(std::size_t column) const;  ///< 0 or 1
  /// The text, without the blanks around it. Lives as long as the reader and the text of the table.
  [[nodiscard]] std::string_view cell(std::size_t column) const { return cells_[column]; }
  /// Nothing stands there; an escaped text may be empty and stand there.
  [[nodiscard]] bool is_blank(std::size_t column) const { return written_[column].empty(); }

  /// "<name>:<line>:<column>: <message>" for a cell of the row, or of the line with the names before the first row.
  [[nodiscard]] Error at(std::size_t column, const std::string& message) const;
  [[nodiscard]] Error at_line(std::uint64_t line, const std::string& message) const;
  [[nodiscard]] std::uint64_t line() const { return line_; }

 private:
  CsvReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}
  bool next_line();
  void add_setting(std::string_view line, std::vector<CsvSetting>& settings) const;
  void split();
  Status take_escapes();
  [[nodiscard]] std::string place(std::uint64_t line, std::size_t byte, bool of_body) const;
  template <class Number>
  [[nodiscard]] Result<Number> parse(std::size_t column, const char* wanted) const;

  std::string_view text_;
  std::string name_;
  std::size_t begin_ = 0;     // of the next line
  std::string_view current_;  // the line
  std::uint64_t line_ = 0;    // its number
  bool has_end_ = true;       // a line end stands behind it
  std::vector<CsvSetting> settings_;
  std::vector<CsvSetting> passed_over_;
  std::vector<std::string> columns_;
  std::vector<std::string_view> written_;  // the cells of the line
  std::vector<std::string_view> cells_;    // what they say
  std::set<std::string, std::less<>> decoded_;
  bool escaped_ = false;
  std::uint64_t line_of_names_ = 0;  // 0: not read yet
};

}  // namespace tumble::replay
