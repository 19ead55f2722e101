#include "tools/arguments/measure_arguments.h"

#include <algorithm>
#include <string>
#include <utility>

#include "replay/measure/metric_list.h"
#include "src/base/text.h"
#include "tools/arguments/arguments.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {

std::vector<std::string> metric_words() {
  std::vector<std::string> words;
  for (const replay::MetricRow& metric : replay::metric_list()) words.emplace_back(metric.name);
  return words;
}

void add_measure(Arguments& arguments, MeasureArguments& target) {
  arguments.option(
      "--bodies", "LIST", target.bodies,
      "Measure these: ids (7), ranges (3-9), names, tables of the scene (grid, tower:1, input), joined by commas");
  arguments
      .option("--axis", "AXIS", target.axis,
              "The axis along which nothing should move: x (if not given) or y; in an imported session, one of its own")
      .offers({"x", "y", "z"});
  arguments.whole("--from-step", "K", target.from_step, 0, sim::kStepsMax,
                  "Measure from the state after step K on, as if it were the start");
}

Result<replay::MeasureOptions> parse_measure(const MeasureArguments& arguments, const replay::EngineAxes& axes,
                                             const replay::BodyTable& named) {
  replay::MeasureOptions how;
  Result<replay::BodyChoice> bodies = replay::parse_bodies(arguments.bodies, named);
  if (!bodies.ok()) return bad_input("--" + bodies.error().message);
  how.bodies = *std::move(bodies);
  const std::string first(1, axes.along(0).letter), second(1, axes.along(1).letter);
  if (!arguments.axis.empty() && arguments.axis != first && arguments.axis != second) {
    const std::string up(1, axes.along(2).letter);
    return bad_input("--axis: found " + in_quotes(arguments.axis) + ", wanted " + std::min(first, second) + " or " +
                     std::max(first, second) + "; " + up + " points up");
  }
  how.lateral = arguments.axis == second ? replay::LateralAxis::kY : replay::LateralAxis::kX;
  how.from_step = arguments.from_step.value_or(0);
  return how;
}

}  // namespace tumble::tools
