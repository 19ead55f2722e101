#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/base/text.h"
#include "src/scenes/toml.h"
#include "tumble/sim/result.h"

namespace tumble::scenes {

/// The place of a value or key for messages: "file:line:column", or the `--set` argument.
class Place {
 public:
  Place() = default;
  explicit Place(const toml::source_region& region) : region_(region) {}

  /// Whether the value came from `--set`; the path of its region is then the argument's text.
  [[nodiscard]] bool is_override() const { return region_.path != nullptr; }
  [[nodiscard]] std::string text(std::string_view file_name) const;

 private:
  toml::source_region region_;
};

/// The first error in a scene. After an error, readers continue with defaults, so that they need no early exits. Code
/// that allocates by a number from the scene calls found() first.
class Problem {
 public:
  explicit Problem(std::string_view file_name) : file_name_(file_name) {}

  /// Keeps the error "<place>: <message>" unless there is one already.
  void report(const Place& place, std::string_view message);

  [[nodiscard]] bool found() const { return first_.has_value(); }
  [[nodiscard]] const Error& error() const { return *first_; }
  [[nodiscard]] std::string place_text(const Place& place) const { return place.text(file_name_); }

 private:
  std::string file_name_;
  std::optional<Error> first_;
};

/// A TOML value in a few words: `[1.0, -2.0, 1.0]`, `"abc"`, `a table`. Bounded, printable, whatever the value holds.
std::string describe(const toml::node& node);

}  // namespace tumble::scenes
