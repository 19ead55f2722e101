#include "tools/arguments/arguments.h"

#include <charconv>

#include "src/base/text.h"

namespace tumble::tools {
namespace {

constexpr std::uint64_t kThreadsMax = 256;

template <class T>
std::optional<T> parse(const std::string& text) {
  T value{};
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end) return std::nullopt;
  return value;
}

CLI::ValidationError wrong(const std::string& name, const std::string& found, const std::string& wanted) {
  return CLI::ValidationError(name, found_wanted(in_quotes(found), wanted));
}

}  // namespace

std::optional<std::uint64_t> parse_whole(const std::string& text) { return parse<std::uint64_t>(text); }
std::optional<double> parse_number(const std::string& text) { return parse<double>(text); }

CLI::Option* add_whole(CLI::App& app, const std::string& name, std::optional<std::uint64_t>& target, std::uint64_t low,
                       std::uint64_t high, const std::string& description) {
  const auto read = [&target, name, low, high](const std::string& text) {
    target = parse_whole(text);
    if (target && *target >= low && *target <= high) return;
    throw wrong(name, text, "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
  };
  return app.add_option_function<std::string>(name, read, description);
}

CLI::Option* add_positive(CLI::App& app, const std::string& name, std::optional<double>& target, double high,
                          const std::string& description) {
  const auto read = [&target, name, high](const std::string& text) {
    target = parse_number(text);
    if (target && *target > 0 && *target <= high) return;
    throw wrong(name, text, "a number above 0, at most " + number_text(high));
  };
  return app.add_option_function<std::string>(name, read, description);
}

CLI::Option* add_json(CLI::App& app, bool& target) {
  return app.add_flag("--json", target, "Print JSON to standard output");
}

CLI::Option* add_threads(CLI::App& app, std::optional<std::uint64_t>& target) {
  return add_whole(app, "--threads", target, 1, kThreadsMax, "Threads to step with; the result does not depend on it")
      ->type_name("N");
}

}  // namespace tumble::tools
