#include "tumble/golden/scene_changes.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "golden/suite/text_files.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

/// More pairs of lines than this are not compared for the longest common sequence; those between the first difference
/// and the last then pair in their order.
constexpr std::size_t kPairsMax = 4'000'000;

struct Line {
  std::size_t number = 0;
  std::string table;
  std::string key;  ///< of a text over several lines: the key that it belongs to
  std::string text;
  friend bool operator==(const Line& a, const Line& b) { return a.table == b.table && a.text == b.text; }
};

/// Without a comment and without blanks around it. open: the quotes of a text that goes on from the line before, and of
/// one that goes on in the next line; else empty.
std::string content_of(std::string_view line, std::string_view& open) {
  constexpr std::array<std::string_view, 4> kQuotes = {"\"\"\"", "'''", "\"", "'"};
  std::size_t end = 0;
  for (; end < line.size(); ++end) {
    const std::string_view rest = line.substr(end);
    if (!open.empty()) {
      if (rest.starts_with(open)) {
        end += open.size() - 1;
        open = {};
      } else if (rest.front() == '\\' && open.front() == '"') {
        ++end;
      }
      continue;
    }
    if (rest.front() == '#') break;
    const auto* const quote = std::ranges::find_if(kQuotes, [&](std::string_view q) { return rest.starts_with(q); });
    if (quote == kQuotes.end()) continue;
    open = *quote;
    end += open.size() - 1;
  }
  if (open.size() == 1) open = {};
  line = line.substr(0, end);
  const std::size_t from = line.find_first_not_of(" \t");
  return from == std::string_view::npos ? "" : std::string(line.substr(from, line.find_last_not_of(" \t") - from + 1));
}

bool is_table(const std::string& text) {
  const std::size_t name = text.find_first_not_of('[');
  return text.front() == '[' && text.back() == ']' && text.find('=') == std::string::npos &&
         name != std::string::npos && std::isalpha(static_cast<unsigned char>(text[name])) != 0;
}

/// Words and looks, which no session depends on.
bool is_only_looks(const Line& line) {
  constexpr std::array<std::string_view, 3> kWords = {"title", "name", "category"};
  if (line.table.empty() && std::ranges::find(kWords, line.key) != kWords.end()) return true;
  return line.key == "texture" || line.table.starts_with("[camera") || line.table.starts_with("[light") ||
         line.table.starts_with("[[light");
}

std::vector<Line> lines_that_count(std::string_view scene) {
  std::vector<Line> lines;
  std::string table, key;
  std::string_view open;
  std::size_t number = 0;
  for (const std::string& whole : lines_of(scene)) {
    ++number;
    const bool goes_on = !open.empty();
    std::string text = content_of(whole, open);
    if (text.empty()) continue;
    if (!goes_on) key = text.substr(0, text.find_first_of(" ="));
    if (!goes_on && is_table(text)) table = text;
    Line line{number, table, key, std::move(text)};
    if (!is_only_looks(line)) lines.push_back(std::move(line));
  }
  return lines;
}

using Lines = std::vector<Line>;

/// Whether each line of `a` and `b` belongs to a longest common sequence of both.
struct Common {
  std::vector<bool> a, b;
};

/// The longest common sequence of the lines from `from` to to_a and to_b.
void mark_between(const Lines& a, const Lines& b, std::size_t from, std::size_t to_a, std::size_t to_b,
                  Common& common) {
  if ((to_a - from) * (to_b - from) > kPairsMax) {
    for (std::size_t i = from; i < std::min(to_a, to_b); ++i) common.a[i] = common.b[i] = a[i] == b[i];
    return;
  }
  const std::size_t width = to_b - from + 1;
  std::vector<std::uint32_t> lengths((to_a - from + 1) * width);
  const auto length = [&](std::size_t i, std::size_t j) -> std::uint32_t& {  // of the longest sequence from (i, j) on
    return lengths[(i - from) * width + (j - from)];
  };
  for (std::size_t i = to_a; i-- > from;) {
    for (std::size_t j = to_b; j-- > from;) {
      length(i, j) = a[i] == b[j] ? length(i + 1, j + 1) + 1 : std::max(length(i + 1, j), length(i, j + 1));
    }
  }
  for (std::size_t i = from, j = from; i < to_a && j < to_b;) {
    if (a[i] == b[j]) {
      common.a[i++] = common.b[j++] = true;
    } else if (length(i + 1, j) >= length(i, j + 1)) {
      ++i;
    } else {
      ++j;
    }
  }
}

/// The lines before the first difference and behind the last are common; only those between are searched.
Common common_lines(const Lines& a, const Lines& b) {
  Common common{std::vector<bool>(a.size()), std::vector<bool>(b.size())};
  std::size_t from = 0, to_a = a.size(), to_b = b.size();
  for (; from < std::min(to_a, to_b) && a[from] == b[from]; ++from) common.a[from] = common.b[from] = true;
  while (std::min(to_a, to_b) > from && a[to_a - 1] == b[to_b - 1]) common.a[--to_a] = common.b[--to_b] = true;
  mark_between(a, b, from, to_a, to_b, common);
  return common;
}

/// One stretch between common lines: lines of one key pair, the others come or go.
void add_stretch(Lines gone, const Lines& came, std::vector<SceneChange>& changes) {
  for (const Line& line : came) {
    const auto old = std::ranges::find_if(
        gone, [&](const Line& other) { return other.table == line.table && other.key == line.key; });
    changes.push_back({line.number, line.table, old == gone.end() ? "" : old->text, line.text});
    if (old != gone.end()) gone.erase(old);
  }
  for (const Line& line : gone) changes.push_back({line.number, line.table, line.text, ""});
}

/// The change of an engine's file, whose name stands in place of a table.
bool is_file(const SceneChange& change) { return !change.table.empty() && change.table.front() != '['; }

std::string change_of_file(const SceneChange& change) {
  const std::string& before = change.before;
  const std::string& after = change.after;
  if (change.line == 0) {
    const std::string what = before + after;
    return change.table + (what.empty() ? " (the golden does not keep its text: git's history has it)" : ": " + what);
  }
  const std::string place = change.table + ", line " + std::to_string(change.line) + ": ";
  if (before.empty()) return place + "new: " + shortened(after);
  return place + (after.empty() ? "gone: " + shortened(before) : shortened(before) + " → " + shortened(after));
}

std::string value_of(const std::string& line) {
  const std::size_t equals = line.find('=');
  const std::size_t from = equals == std::string::npos ? 0 : line.find_first_not_of(' ', equals + 1);
  return from == std::string::npos ? "" : line.substr(from);
}

}  // namespace

std::string describe(const SceneChange& change) {
  if (is_file(change)) return change_of_file(change);
  const std::string place = (change.after.empty() ? "line " + std::to_string(change.line) + " of the old scene"
                                                  : "line " + std::to_string(change.line)) +
                            (change.table.empty() ? "" : ", " + change.table) + ": ";
  if (change.before.empty()) return place + "new: " + change.after;
  if (change.after.empty()) return place + "gone: " + change.before;
  return place + change.before + " → " + value_of(change.after);
}

std::vector<SceneChange> scene_changes(std::string_view before, std::string_view after) {
  const Lines a = lines_that_count(before), b = lines_that_count(after);
  const Common common = common_lines(a, b);
  std::vector<SceneChange> changes;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    Lines gone, came;
    while (i < a.size() && !common.a[i]) gone.push_back(a[i++]);
    while (j < b.size() && !common.b[j]) came.push_back(b[j++]);
    add_stretch(std::move(gone), came, changes);
    if (i < a.size()) ++i;
    if (j < b.size()) ++j;
  }
  return changes;
}

}  // namespace tumble::golden
