#include "src/scenes/parse_toml.h"

#include <cstddef>
#include <utility>

namespace tumble::scenes {
namespace {

constexpr std::size_t kTextMax = std::size_t{16} << 20;  // bytes; the tree takes some 40 times as much
constexpr std::size_t kDotsMax = 256;                    // in one line

constexpr const char* kNotToml = "text that is not TOML";

// The first line with too many dots, or 0.
toml::source_index crowded_line(std::string_view text) {
  toml::source_index line = 1;
  std::size_t dots = 0;
  for (char c : text) {
    if (c == '.') ++dots;
    if (dots > kDotsMax) return line;
    if (c != '\n') continue;
    ++line;
    dots = 0;
  }
  return 0;
}

Place place_in(toml::source_position position, const std::string& source) {
  toml::source_region region;
  region.begin = position;
  if (!source.empty()) region.path = std::make_shared<const std::string>(source);
  return Place(region);
}

}  // namespace

std::optional<toml::table> parse_toml(std::string_view text, const std::string& source, Problem& problem) {
  if (text.size() > kTextMax) {
    problem.report(place_in({}, source), found_wanted(std::to_string(text.size()) + " bytes",
                                                      "a scene of at most " + std::to_string(kTextMax)));
    return std::nullopt;
  }
  if (const toml::source_index line = crowded_line(text); line > 0) {
    problem.report(place_in({line, 1}, source),
                   found_wanted("a line of more than " + std::to_string(kDotsMax) + " dots", "fewer of them"));
    return std::nullopt;
  }
  try {
    toml::parse_result parsed = toml::parse(text, source);
    if (parsed) return std::move(parsed).table();
    problem.report(place_in(parsed.error().source().begin, source),
                   found_wanted(kNotToml, "TOML 1.0") + ": " + std::string(parsed.error().description()));
  } catch (const BrokenAssertion&) {
    problem.report(place_in({}, source), found_wanted(kNotToml, "TOML 1.0: look for a stray character after ["));
  }
  return std::nullopt;
}

}  // namespace tumble::scenes
