#include "replay/import/csv/csv_reader.h"

#include <algorithm>
#include <charconv>
#include <utility>

#include "replay/arrays/pair_cell.h"
#include "replay/format/limits.h"
#include "src/base/text.h"

namespace tumble::replay {
namespace {

constexpr std::size_t kShown = 40;  // bytes of a cell in a message

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r");
  if (begin == std::string_view::npos) return text.substr(text.size());  // empty, but still a place in the line
  return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

/// An error where the names of the columns are written as other programs write them; else empty.
std::string wrong_separator(std::string_view line, std::size_t cells) {
  const bool by_semicolon = line.find(';') != std::string_view::npos,
             by_tab = line.find('\t') != std::string_view::npos;
  if (cells == 1 && (by_semicolon || by_tab)) {
    return std::string("found columns apart by ") + (by_semicolon ? "semicolons" : "tabs") +
           ", wanted commas, and points in numbers";
  }
  return line.starts_with('"') ? "found names in quotes, wanted names and cells without quotes" : "";
}

}  // namespace

bool CsvReader::next_line() {
  if (begin_ >= text_.size()) return false;
  const std::size_t found = text_.find('\n', begin_);
  has_end_ = found != std::string_view::npos;
  const std::size_t end = has_end_ ? found : text_.size();
  current_ = text_.substr(begin_, end - begin_);
  begin_ = end + 1;
  ++line_;
  return true;
}

void CsvReader::split() {
  written_.clear();
  for (std::size_t begin = 0; begin <= current_.size();) {
    const std::size_t end = std::min(current_.find(',', begin), current_.size());
    written_.push_back(trimmed(current_.substr(begin, end - begin)));
    begin = end + 1;
  }
  cells_ = written_;
  if (!escaped_) return;
  for (std::string_view& cell : cells_) {
    if (cell.find('%') != std::string_view::npos) cell = *decoded_.insert(text_in_cell(cell)).first;
  }
}

/// The setting tells how to read the names of the columns already.
Status CsvReader::take_escapes() {
  const auto found = std::ranges::find(settings_, kEscapesKey, &CsvSetting::key);
  if (found == settings_.end()) return {};
  if (found->value != kEscapesValue) {
    return at_line(found->line, "escapes: " + found_wanted(in_quotes(found->value), kEscapesValue));
  }
  escaped_ = true;
  settings_.erase(found);
  return {};
}

/// Adds the setting of a line that begins with #. A line without a colon is a remark.
void CsvReader::add_setting(std::string_view line, std::vector<CsvSetting>& settings) const {
  const std::size_t colon = line.find(':');
  if (colon == std::string_view::npos) return;
  settings.push_back(
      {std::string(trimmed(line.substr(1, colon - 1))), std::string(trimmed(line.substr(colon + 1))), line_});
}

Result<CsvReader> CsvReader::open(std::string_view text, std::string name) {
  constexpr std::string_view kMark = "\xef\xbb\xbf";  // which some editors put before UTF-8
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  CsvReader reader(text, std::move(name));
  while (reader.next_line()) {
    const std::string_view line = trimmed(reader.current_);
    if (line.empty()) continue;
    if (line.front() == '#') {
      reader.add_setting(line, reader.settings_);
      continue;
    }
    if (Status ok = reader.take_escapes(); !ok.ok()) return ok.error();
    reader.split();
    if (reader.cells_.size() > kTableColumnsMax) {
      return reader.at_line(reader.line_, "found " + std::to_string(reader.cells_.size()) +
                                              " columns, wanted at most " + std::to_string(kTableColumnsMax));
    }
    if (std::string wrong = wrong_separator(reader.current_, reader.cells_.size()); !wrong.empty())
      return reader.at_line(reader.line_, wrong);
    reader.line_of_names_ = reader.line_;
    reader.columns_.assign(reader.cells_.begin(), reader.cells_.end());
    return reader;
  }
  return reader.at_line(std::max<std::uint64_t>(reader.line_, 1), "found no line with the names of the columns");
}

std::optional<std::size_t> CsvReader::find(std::string_view column) const {
  const auto found = std::ranges::find(columns_, column);
  if (found == columns_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns_.begin());
}

bool CsvReader::rename(std::string_view column, const std::string& name) {
  const std::optional<std::size_t> found = find(column);
  if (found) columns_[*found] = name;
  return found.has_value();
}

Result<bool> CsvReader::next() {
  passed_over_.clear();
  while (next_line()) {
    const std::string_view line = trimmed(current_);
    if (line.empty()) continue;
    if (line.front() == '#') {
      add_setting(line, passed_over_);
      if (!passed_over_.empty() && passed_over_.back().key == kEscapesKey) {
        return at_line(line_, "found the key escapes below the names of the columns, wanted it before them");
      }
      continue;
    }
    split();
    const bool whole = cells_.size() == columns_.size();
    if (whole && has_end_) return true;
    std::string found = "found " + count_text(cells_.size(), "cell") + ", wanted " + std::to_string(columns_.size()) +
                        ", one for each column";
    if (whole) found = "found no line end behind this row, wanted one";
    if (!has_end_) found += "; the table may have been cut here; if nothing is missing, end its last line";
    return at_line(line_, found);
  }
  return false;
}

Result<bool> CsvReader::flag(std::size_t column) const {
  const Result<std::uint64_t> value = whole(column);
  if (!value.ok()) return value.error();
  if (*value <= 1) return *value == 1;
  return at(column, columns_[column] + ": " + found_wanted(std::to_string(*value), "0 or 1"));
}

template <class Number>
Result<Number> CsvReader::parse(std::size_t column, const char* wanted) const {
  std::string_view cell = cells_[column];
  if (cell.starts_with('+')) cell.remove_prefix(1);
  Number value{};
  const auto [stop, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error == std::errc() && stop == cell.data() + cell.size() && !cell.empty()) return value;
  return at(column, columns_[column] + ": found \"" + std::string(cells_[column].substr(0, kShown)) + "\", wanted " +
                        (error == std::errc::result_out_of_range ? "a number that its type holds" : wanted));
}

// exact_bits() writes "nan(0x…)", whose bits std::from_chars would pass over.
Result<double> CsvReader::number(std::size_t column) const {
  const std::string_view cell = cells_[column];
  if (!cell.ends_with(')')) return parse<double>(column, "a number");
  if (const std::optional<double> bits = parse_exact(cell)) return *bits;
  return at(column, columns_[column] + ": " +
                        found_wanted(in_quotes(cell),
                                     "a number; nan(0x…) and inf(0x…) have the 16 hexadecimal digits "
                                     "of such a number behind 0x"));
}

Result<double> CsvReader::single(std::size_t column) const {
  if (cells_[column].ends_with(')')) return number(column);
  const Result<float> value = parse<float>(column, "a number");
  if (!value.ok()) return value.error();
  return static_cast<double>(*value);
}

Result<std::uint64_t> CsvReader::whole(std::size_t column) const {
  return parse<std::uint64_t>(column, "a whole number from 0 on");
}

/// Where a message points to. Lines of a table that was made of arrays are rows, each of a step and a body.
std::string CsvReader::place(std::uint64_t line, std::size_t byte, bool of_body) const {
  if (!text_.starts_with(kRowsOfArrays)) {
    return name_ + ":" + std::to_string(line) + ":" + std::to_string(byte) + ": ";
  }
  if (line_of_names_ == 0 || line <= line_of_names_) return name_ + ": ";
  CsvReader row(text_, name_);
  if (line != line_) {
    while (row.line_ < line && row.next_line()) continue;
    row.escaped_ = escaped_;
    row.split();
  }
  const auto cell = [&](std::string_view column) {
    const std::vector<std::string_view>& cells = line == line_ ? cells_ : row.cells_;
    const std::optional<std::size_t> k = find(column);
    return k && *k < cells.size() ? std::string(cells[*k]) : std::string();
  };
  const std::string step = cell("step"), body = of_body ? cell("id") : "";
  return name_ + ": " + (step.empty() ? "time " + cell("time") + " s" : "step " + step) +
         (body.empty() ? "" : ", body " + body) + ": ";
}

Error CsvReader::at(std::size_t column, const std::string& message) const {
  const std::size_t byte = static_cast<std::size_t>(written_[column].data() - current_.data()) + 1;
  return bad_input(place(line_, byte, true) + message);
}

Error CsvReader::at_line(std::uint64_t line, const std::string& message) const {
  return bad_input(place(line, 1, false) + message);
}

}  // namespace tumble::replay
