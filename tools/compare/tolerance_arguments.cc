#include "tools/compare/tolerance_arguments.h"

#include <algorithm>
#include <optional>

#include "src/base/text.h"
#include "tools/arguments/numbers.h"
#include "tools/output/text.h"

namespace tumble::tools {
namespace {

// A tolerance for a channel that is not compared would excuse nothing.
Status check_both_have(const replay::Tolerances& tolerances, const replay::LogReader& a, const replay::LogReader& b) {
  const std::string prefix = "channel.";
  for (const auto& [field, value] : tolerances.fields) {
    if (!field.starts_with(prefix)) continue;
    for (const replay::LogReader* log : {&a, &b}) {
      const std::vector<replay::Channel>& channels = log->header().declared.channels;
      const auto at = std::ranges::find(channels, field.substr(prefix.size()), &replay::Channel::name);
      if (at != channels.end() && replay::is_number(at->type.kind)) continue;
      return bad_input("--tolerance " + field + ": found no such channel of numbers in " + printable(log->name()) +
                       ", so it is not compared; wanted one that both logs have");
    }
  }
  return {};
}

std::vector<replay::Channel> channels_of(const replay::LogReader& a, const replay::LogReader& b) {
  std::vector<replay::Channel> channels = a.header().declared.channels;
  for (const replay::Channel& channel : b.header().declared.channels) {
    if (a.header().declared.find(channel.name) == a.header().declared.channels.size()) channels.push_back(channel);
  }
  return channels;
}

}  // namespace

Result<replay::Tolerances> parse_tolerances(const std::vector<std::string>& arguments, const replay::LogReader& a,
                                            const replay::LogReader& b) {
  const std::vector<replay::Channel> channels = channels_of(a, b);
  replay::Tolerances tolerances;
  for (const std::string& argument : arguments) {
    const std::size_t equals = argument.find('=');
    const std::optional<double> value =
        equals == std::string::npos ? std::nullopt : parse_number(argument.substr(equals + 1));
    if (!value) {
      return bad_input("--tolerance: found " + in_quotes(argument) +
                       ", wanted FIELD=V with a number V, as in position=1e-9");
    }
    const Status set = replay::set_tolerance(tolerances, argument.substr(0, equals), *value, channels);
    if (!set.ok()) return bad_input("--tolerance " + printable(argument) + ": " + set.error().message);
  }
  if (Status ok = check_both_have(tolerances, a, b); !ok.ok()) return ok.error();
  return tolerances;
}

}  // namespace tumble::tools
