#include "tools/arguments/step_range.h"

#include <optional>

#include "src/base/text.h"
#include "tools/arguments/numbers.h"

namespace tumble::tools {

Result<StepRange> check_range(const StepRange& range, const replay::LogReader& log) {
  if (range.first >= log.first_state() && range.last <= log.last_step()) return range;
  const std::uint64_t missing = range.first < log.first_state() ? range.first : range.last;
  const std::string message = log.name() + ": found no step " + std::to_string(missing) + "; the log holds steps " +
                              std::to_string(log.first_state()) + " to " + std::to_string(log.last_step());
  if (log.condition().whole()) return bad_input(message);
  return damaged(message + "; it is " + log.condition().summary(log.last_step()));
}

Result<StepRange> parse_range(const std::string& text, const replay::LogReader& log) {
  const std::size_t colon = text.find(':');
  const std::optional<std::uint64_t> first = parse_whole(text.substr(0, colon));
  const std::optional<std::uint64_t> last =
      colon == std::string::npos ? std::nullopt : parse_whole(text.substr(colon + 1));
  if (!first || !last || *first > *last) {
    return bad_input("--steps: found " + in_quotes(text) + ", wanted A:B with whole numbers A <= B, as in 0:60");
  }
  return check_range({*first, *last}, log);
}

}  // namespace tumble::tools
