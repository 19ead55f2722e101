#include "golden/suite/scene_changes.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "golden/suite/text_files.h"

namespace tumble::golden {
namespace {

/// More pairs of lines than this are not compared for the longest common sequence; lines then pair in their order.
constexpr std::size_t kPairsMax = 4'000'000;

struct Line {
  std::size_t number = 0;
  std::string table;
  std::string text;
  [[nodiscard]] std::string key() const { return text.substr(0, text.find_first_of(" =")); }
  friend bool operator==(const Line& a, const Line& b) { return a.table == b.table && a.text == b.text; }
};

/// Without a comment and without blanks around it.
std::string content_of(const std::string& line) {
  char quote = 0;
  std::size_t end = 0;
  for (; end < line.size(); ++end) {
    const char c = line[end];
    if (quote == 0 && c == '#') break;
    if (c == '"' || c == '\'') quote = quote == 0 ? c : quote == c ? '\0' : quote;
  }
  const std::size_t from = line.find_first_not_of(" \t");
  if (from == std::string::npos || from >= end) return "";
  const std::size_t to = line.find_last_not_of(" \t", end - 1);
  return line.substr(from, to - from + 1);
}

/// Words and looks, which no session depends on.
bool is_only_looks(const Line& line) {
  constexpr std::array<std::string_view, 5> kWords = {"title", "name", "category", "description", "figure"};
  if (line.table.empty() && std::ranges::find(kWords, line.key()) != kWords.end()) return true;
  return line.table.starts_with("[camera") || line.table.starts_with("[light") || line.table.starts_with("[[light");
}

std::vector<Line> lines_that_count(std::string_view scene) {
  std::vector<Line> lines;
  std::string table;
  std::size_t number = 0;
  for (const std::string& whole : lines_of(scene)) {
    ++number;
    std::string text = content_of(whole);
    if (text.empty()) continue;
    if (text.front() == '[' && text.back() == ']' && text.find('=') == std::string::npos) table = text;
    Line line{number, table, std::move(text)};
    if (!is_only_looks(line)) lines.push_back(std::move(line));
  }
  return lines;
}

using Lines = std::vector<Line>;

/// Whether each line of `a` and `b` belongs to a longest common sequence of both.
struct Common {
  std::vector<bool> a, b;
};

Common common_lines(const Lines& a, const Lines& b) {
  Common common{std::vector<bool>(a.size()), std::vector<bool>(b.size())};
  if (a.size() * b.size() > kPairsMax) {
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) common.a[i] = common.b[i] = a[i] == b[i];
    return common;
  }
  const std::size_t width = b.size() + 1;
  std::vector<std::uint32_t> length((a.size() + 1) * width);  // of the longest sequence from (i, j) on
  for (std::size_t i = a.size(); i-- > 0;) {
    for (std::size_t j = b.size(); j-- > 0;) {
      length[i * width + j] = a[i] == b[j] ? length[(i + 1) * width + j + 1] + 1
                                           : std::max(length[(i + 1) * width + j], length[i * width + j + 1]);
    }
  }
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i] == b[j]) {
      common.a[i++] = common.b[j++] = true;
    } else if (length[(i + 1) * width + j] >= length[i * width + j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
  return common;
}

/// One stretch between common lines: lines of one key pair, the others come or go.
void add_stretch(Lines gone, const Lines& came, std::vector<SceneChange>& changes) {
  for (const Line& line : came) {
    const auto old = std::ranges::find_if(
        gone, [&](const Line& other) { return other.table == line.table && other.key() == line.key(); });
    changes.push_back({line.number, line.table, old == gone.end() ? "" : old->text, line.text});
    if (old != gone.end()) gone.erase(old);
  }
  for (const Line& line : gone) changes.push_back({line.number, line.table, line.text, ""});
}

std::string value_of(const std::string& line) {
  const std::size_t equals = line.find('=');
  const std::size_t from = equals == std::string::npos ? 0 : line.find_first_not_of(' ', equals + 1);
  return from == std::string::npos ? "" : line.substr(from);
}

}  // namespace

std::string describe(const SceneChange& change) {
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
