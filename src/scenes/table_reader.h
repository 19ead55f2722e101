#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/scenes/problem.h"
#include "tumble/sim/vec.h"

namespace tumble::scenes {

/// The range of a number and its words in messages: "a mass from 1e-09 to 1000000000000.0 kg". Bounds are inclusive.
struct NumberRule {
  const char* noun;
  double low;
  double high;
  const char* unit;

  [[nodiscard]] bool holds(double value) const { return value >= low && value <= high; }  // false for NaN
  [[nodiscard]] std::string text() const;
};

/// The range of a whole number and its words in messages.
struct IntegerRule {
  const char* noun;
  std::uint64_t low;
  std::uint64_t high;

  [[nodiscard]] bool holds(std::uint64_t value) const { return value >= low && value <= high; }
  [[nodiscard]] std::string text() const;
};

/// One table of a scene, read key by key. Each getter checks type and range, and reports a wrong value to `problem`.
/// finish() reports the first key that no getter read, or else the first required key that is missing. The table and
/// the problem must outlive the reader.
class TableReader {
 public:
  /// label: as messages name the table, "[[box]]". prefix: of keys inside a key's own table, "material.".
  TableReader(const toml::table& table, std::string label, Problem& problem, std::string prefix = "");

  [[nodiscard]] bool has(std::string_view key);

  // Optional keys: the fallback where the key is missing, and after an error.
  double number(std::string_view key, double fallback, const NumberRule& rule);
  std::uint64_t integer(std::string_view key, std::uint64_t fallback, const IntegerRule& rule);
  sim::Vec3 vector(std::string_view key, const sim::Vec3& fallback, const NumberRule& each);
  /// Fill `out` with as many numbers as it holds. Return false and leave it as it was where the key is missing, and
  /// after an error.
  bool numbers(std::string_view key, std::span<double> out, const NumberRule& each);
  bool integers(std::string_view key, std::span<std::uint64_t> out, const IntegerRule& each);
  bool flag(std::string_view key, bool fallback);
  std::string text(std::string_view key, std::string fallback, std::size_t length_max);
  /// The index of the word found among `words`.
  std::size_t choice(std::string_view key, std::size_t fallback, std::span<const char* const> words);

  // Required keys: after an error the lowest value of the rule, the first word, or false. missing: the words of the
  // message about a missing key; where has() has found the key, none are needed.
  double required_number(std::string_view key, const NumberRule& rule, std::string_view missing = "");
  std::uint64_t required_integer(std::string_view key, const IntegerRule& rule, std::string_view missing = "");
  sim::Vec3 required_vector(std::string_view key, const NumberRule& each, std::string_view missing = "");
  bool required_flag(std::string_view key, std::string_view missing = "");
  std::size_t required_choice(std::string_view key, std::span<const char* const> words, std::string_view missing = "");

  /// The table under a key, or null.
  const toml::table* table(std::string_view key);
  /// The tables [[key]], or null.
  const toml::array* array_of_tables(std::string_view key);

  /// Reports a key whose value is wrong in a way the getters cannot know. A missing key is reported by finish(), after
  /// unknown keys: a missing key is often a misspelt one, and the message about the misspelling helps more.
  void fail(std::string_view key, std::string_view wanted);
  void finish();

  /// The place of the key's value, or of the table if the key is missing.
  [[nodiscard]] Place place(std::string_view key) const;
  [[nodiscard]] Place place() const { return Place(table_.source()); }
  [[nodiscard]] const std::string& label() const { return label_; }
  [[nodiscard]] Problem& problem() const { return problem_; }

 private:
  const toml::node* find(std::string_view key);
  void require(std::string_view key, std::string_view missing);
  [[nodiscard]] std::string key_text(std::string_view key) const;

  const toml::table& table_;
  std::string label_;
  Problem& problem_;
  std::string prefix_;
  std::vector<std::string_view> known_;  // keys asked for; the texts are literals
  std::string missing_;                  // the message about the first missing key
};

}  // namespace tumble::scenes
