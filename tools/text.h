#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// How results look: for people, aligned and with units; for programs, exact.
namespace tumble::tools {

/// Keys stay in the order in which they are set.
using Json = nlohmann::ordered_json;

/// Prints JSON and a newline to stdout. Numbers read back to the same bits; text that is not UTF-8 (a log may hold any)
/// gets replacement characters.
void print_json(const Json& json);

/// The shortest decimal that reads back to the same double.
std::string exact(double value);

/// For people: four significant digits, "0" for 0, the unit behind it. "1.234e-07 m", "45.3 J".
std::string rounded(double value, std::string_view unit);

std::string bytes_text(std::uint64_t bytes);               ///< "812 bytes", "4.21 MB"
std::string count_text(std::uint64_t n, const char* one);  ///< "1 body", "222 bodies", "12 steps"
std::string seconds_text(double seconds);                  ///< "5.00 s", "12 ms"

/// Control characters as '?': text from a file must not drive the terminal.
std::string printable(std::string_view text);

/// With spaces to at least `width` columns (UTF-8 aware), on the right or, for numbers, on the left.
std::string padded(std::string_view text, std::size_t width);
std::string padded_left(std::string_view text, std::size_t width);

/// Lines of "label  value", values aligned.
class Listing {
 public:
  void add(std::string label, std::string value) { lines_.emplace_back(std::move(label), std::move(value)); }
  /// An empty line, and `title` on a line of its own if there is one.
  void section(const std::string& title) { lines_.emplace_back(title.empty() ? "" : "\n" + title, ""); }
  void print() const;

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// A table with a header; columns are as wide as they need to be.
class Table {
 public:
  /// A name that begins with '>' makes a column of numbers, aligned on the right.
  explicit Table(std::vector<std::string> header);
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  void print() const;

 private:
  std::vector<bool> right_;
  std::vector<std::vector<std::string>> rows_;  // the header first
};

}  // namespace tumble::tools
