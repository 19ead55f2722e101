#include "src/scenes/problem.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <vector>

namespace tumble::scenes {
namespace {

constexpr std::size_t kShownLength = 60;    // of a text in a message
constexpr std::size_t kShownElements = 8;   // of an array in a message
constexpr std::size_t kWordLengthMax = 40;  // longer words are no slips of a key

// As TOML writes it, so that a message shows 2.0 where the file says 2.0.
std::string float_text(double value) {
  const std::string text = number_text(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

std::string describe_array(const toml::array& array) {
  std::string out = "[";
  for (std::size_t i = 0; i < array.size(); ++i) {
    if (i > 0) out += ", ";
    if (i == kShownElements) {
      out += "… " + std::to_string(array.size()) + " values";
      break;
    }
    out += array[i].is_array() ? "[…]" : describe(array[i]);
  }
  return out + "]";
}

// Levenshtein's distance, row by row.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replaced});
    }
  }
  return row[b.size()];
}

}  // namespace

std::string Place::text(std::string_view file_name) const {
  if (region_.path) return *region_.path;
  std::string out(file_name);
  if (region_.begin) {
    for (const toml::source_index part : {region_.begin.line, region_.begin.column}) {
      out += ':';
      out += std::to_string(part);
    }
  }
  return out;
}

void Problem::report(const Place& place, std::string_view message) {
  if (!first_) first_ = bad_input(place_text(place) + ": " + std::string(message));
}

std::string found_wanted(std::string_view found, std::string_view wanted) {
  return "found " + std::string(found) + ", wanted " + std::string(wanted);
}

std::string printable(std::string_view text) {
  std::string out;
  for (char c : text.substr(0, kShownLength)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte >= 0x20 && byte < 0x7f ? c : '?';
  }
  return text.size() > kShownLength ? out + "…" : out;
}

std::string quoted(std::string_view text) { return "\"" + printable(text) + "\""; }

std::string number_text(double value) {
  const double size = std::fabs(value);
  const bool plain = size == 0 || (size >= 1e-5 && size < 1e9);
  std::array<char, 32> buffer{};
  char* const last = buffer.data() + buffer.size();
  const auto end = plain ? std::to_chars(buffer.data(), last, value, std::chars_format::fixed)
                         : std::to_chars(buffer.data(), last, value);
  return {buffer.data(), end.ptr};
}

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return quoted(text->get());
  if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point()) return float_text(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_array_of_tables()) return "an array of tables";
  if (const auto* array = node.as_array()) return describe_array(*array);
  return node.is_table() ? "a table" : "a date or time";
}

std::string list_text(const std::vector<std::string_view>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) out += i + 1 == words.size() ? " or " : ", ";
    out += words[i];
  }
  return out;
}

std::string_view nearest_word(std::string_view word, const std::vector<std::string_view>& candidates) {
  if (word.size() > kWordLengthMax) return {};
  std::string_view best;
  std::size_t best_distance = std::max<std::size_t>(1, word.size() / 3) + 1;
  for (std::string_view candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance >= best_distance) continue;
    best_distance = distance;
    best = candidate;
  }
  return best;
}

}  // namespace tumble::scenes
