#include "src/scenes/problem.h"

#include <cstddef>

namespace tumble::scenes {
namespace {

constexpr std::size_t kShownElements = 8;  // of an array in a message

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

std::string describe(const toml::node& node) {
  if (const auto* text = node.as_string()) return in_quotes(text->get());
  if (const auto* integer = node.as_integer()) return std::to_string(integer->get());
  if (const auto* number = node.as_floating_point()) return float_text(number->get());
  if (const auto* flag = node.as_boolean()) return flag->get() ? "true" : "false";
  if (node.is_array_of_tables()) return "an array of tables";
  if (const auto* array = node.as_array()) return describe_array(*array);
  return node.is_table() ? "a table" : "a date or time";
}

}  // namespace tumble::scenes
