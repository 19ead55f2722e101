#include "src/scenes/table_reader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace tumble::scenes {
namespace {

// Whole numbers are accepted where numbers are meant.
std::optional<double> as_number(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return number->get();
  if (const auto* integer = node.as_integer()) return static_cast<double>(integer->get());
  return std::nullopt;
}

std::optional<std::uint64_t> as_count(const toml::node& node) {
  const auto* integer = node.as_integer();
  if (!integer || integer->get() < 0) return std::nullopt;
  return static_cast<std::uint64_t>(integer->get());
}

// Exactly as many elements as `out` holds, each of which `read` accepts; otherwise `out` stays as it was.
template <class T, class Read>
bool fill_from_array(const toml::node& node, std::span<T> out, const Read& read) {
  const toml::array* array = node.as_array();
  if (!array || array->size() != out.size()) return false;
  std::vector<T> values;
  for (const toml::node& element : *array) {
    const std::optional<T> value = read(element);
    if (!value) return false;
    values.push_back(*value);
  }
  std::copy(values.begin(), values.end(), out.begin());
  return true;
}

}  // namespace

std::string NumberRule::text() const {
  return std::string(noun) + " from " + number_text(low) + " to " + number_text(high) + (*unit ? " " : "") + unit;
}

std::string IntegerRule::text() const {
  return std::string(noun) + " from " + std::to_string(low) + " to " + std::to_string(high);
}

TableReader::TableReader(const toml::table& table, std::string label, Problem& problem, std::string prefix)
    : table_(table), label_(std::move(label)), problem_(problem), prefix_(std::move(prefix)) {}

const toml::node* TableReader::find(std::string_view key) {
  if (std::find(known_.begin(), known_.end(), key) == known_.end()) known_.push_back(key);
  return table_.get(key);
}

bool TableReader::has(std::string_view key) { return find(key) != nullptr; }

double TableReader::number(std::string_view key, double fallback, const NumberRule& rule) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  const std::optional<double> value = as_number(*node);
  if (value && rule.holds(*value)) return *value;
  fail(key, rule.text());
  return fallback;
}

std::uint64_t TableReader::integer(std::string_view key, std::uint64_t fallback, const IntegerRule& rule) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  const std::optional<std::uint64_t> value = as_count(*node);
  if (value && rule.holds(*value)) return *value;
  fail(key, rule.text());
  return fallback;
}

sim::Vec3 TableReader::vector(std::string_view key, const sim::Vec3& fallback, const NumberRule& each) {
  std::array<double, 3> values{};
  return numbers(key, values, each) ? sim::Vec3(values[0], values[1], values[2]) : fallback;
}

bool TableReader::numbers(std::string_view key, std::span<double> out, const NumberRule& each) {
  const toml::node* node = find(key);
  if (!node) return false;
  const auto read = [&](const toml::node& element) {
    const std::optional<double> value = as_number(element);
    return value && each.holds(*value) ? value : std::nullopt;
  };
  const bool right = fill_from_array<double>(*node, out, read);
  if (!right) fail(key, each.text());
  return right;
}

bool TableReader::integers(std::string_view key, std::span<std::uint64_t> out, const IntegerRule& each) {
  const toml::node* node = find(key);
  if (!node) return false;
  const auto read = [&](const toml::node& element) {
    const std::optional<std::uint64_t> value = as_count(element);
    return value && each.holds(*value) ? value : std::nullopt;
  };
  const bool right = fill_from_array<std::uint64_t>(*node, out, read);
  if (!right) fail(key, each.text());
  return right;
}

bool TableReader::flag(std::string_view key, bool fallback) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  if (const auto* value = node->as_boolean()) return value->get();
  fail(key, "true or false");
  return fallback;
}

std::string TableReader::text(std::string_view key, std::string fallback, std::size_t length_max) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  if (const auto* value = node->as_string()) {
    const std::string& found = value->get();
    const bool one_line = std::none_of(found.begin(), found.end(), [](char c) {
      const auto byte = static_cast<unsigned char>(c);
      return byte < 0x20 || byte == 0x7f;
    });
    if (one_line && found.size() <= length_max) return found;
  }
  fail(key, "a text of one line and at most " + std::to_string(length_max) + " bytes");
  return fallback;
}

std::size_t TableReader::choice(std::string_view key, std::size_t fallback, std::span<const char* const> words) {
  const toml::node* node = find(key);
  if (!node) return fallback;
  const std::vector<std::string_view> list(words.begin(), words.end());
  std::string hint;
  if (const auto* value = node->as_string()) {
    const auto found = std::find(list.begin(), list.end(), std::string_view(value->get()));
    if (found != list.end()) return static_cast<std::size_t>(found - list.begin());
    const std::string_view near = nearest_word(value->get(), list);
    if (!near.empty()) hint = "; did you mean " + in_quotes(near) + "?";
  }
  fail(key, list_text(list) + hint);
  return fallback;
}

void TableReader::require(std::string_view key, std::string_view missing) {
  if (!has(key)) fail(key, missing);
}

double TableReader::required_number(std::string_view key, const NumberRule& rule, std::string_view missing) {
  require(key, missing);
  return number(key, rule.low, rule);
}

std::uint64_t TableReader::required_integer(std::string_view key, const IntegerRule& rule, std::string_view missing) {
  require(key, missing);
  return integer(key, rule.low, rule);
}

sim::Vec3 TableReader::required_vector(std::string_view key, const NumberRule& each, std::string_view missing) {
  require(key, missing);
  return vector(key, sim::Vec3::Constant(each.low), each);
}

bool TableReader::required_flag(std::string_view key, std::string_view missing) {
  require(key, missing);
  return flag(key, false);
}

std::size_t TableReader::required_choice(std::string_view key, std::span<const char* const> words,
                                         std::string_view missing) {
  require(key, missing);
  return choice(key, 0, words);
}

const toml::table* TableReader::table(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  if (const toml::table* found = node->as_table()) return found;
  fail(key, label_.empty() ? "a table that begins with [" + std::string(key) + "]" : "a table in braces");
  return nullptr;
}

const toml::array* TableReader::array_of_tables(std::string_view key) {
  const toml::node* node = find(key);
  if (!node) return nullptr;
  const toml::array* array = node->as_array();
  if (array && array->is_array_of_tables()) return array;
  fail(key, "tables that begin with [[" + std::string(key) + "]]");
  return nullptr;
}

void TableReader::fail(std::string_view key, std::string_view wanted) {
  const toml::node* node = find(key);
  if (node) {
    problem_.report(place(key), key_text(key) + ": " + found_wanted(describe(*node), wanted));
  } else if (missing_.empty()) {
    missing_ = key_text(key) + ": " + found_wanted("none", wanted);
  }
}

void TableReader::finish() {
  for (const auto& [key, node] : table_) {
    const std::string_view name = key.str();
    if (std::find(known_.begin(), known_.end(), name) != known_.end()) continue;
    const std::string_view near = nearest_word(name, known_);
    const std::string hint = near.empty() ? std::string() : "; did you mean " + in_quotes(near) + "?";
    const Place at(node.source().path ? node.source() : key.source());
    problem_.report(at, key_text(name) + ": " + found_wanted("an unknown key", list_text(known_)) + hint);
    return;
  }
  if (!missing_.empty()) problem_.report(place(), missing_);
}

Place TableReader::place(std::string_view key) const {
  const toml::node* node = table_.get(key);
  return Place(node ? node->source() : table_.source());
}

std::string TableReader::key_text(std::string_view key) const {
  return label_ + (label_.empty() ? "" : " ") + "key " + in_quotes(prefix_ + std::string(key));
}

}  // namespace tumble::scenes
