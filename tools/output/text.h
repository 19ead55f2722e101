#pragma once

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

/// A table with a header; columns are as wide as they need to be. Cells are printed as printable() has them.
class Table {
 public:
  /// A name that begins with '>' makes a column of numbers, aligned on the right.
  explicit Table(std::vector<std::string> header);
  void add(std::vector<std::string> row);
  void print() const;

 private:
  std::vector<bool> right_;
  std::vector<std::vector<std::string>> rows_;  // the header first
};

}  // namespace tumble::tools
