#include "tools/arguments/measure_arguments.h"

#include <utility>

#include "src/base/text.h"
#include "tools/arguments/arguments.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {

void add_measure(Arguments& arguments, MeasureArguments& target) {
  arguments.option(
      "--bodies", "LIST", target.bodies,
      "Measure these: ids (7), ranges (3-9), tables of the scene (grid, tower:1, input), joined by commas");
  arguments.option("--axis", "AXIS", target.axis, "The axis along which nothing should move: x (if not given) or y");
  arguments.whole("--from-step", "K", target.from_step, 0, sim::kStepsMax,
                  "Measure from the state after step K on, as if it were the start");
}

Result<replay::MeasureOptions> parse_measure(const MeasureArguments& arguments) {
  replay::MeasureOptions how;
  Result<replay::BodyChoice> bodies = replay::parse_bodies(arguments.bodies);
  if (!bodies.ok()) return bad_input("--" + bodies.error().message);
  how.bodies = *std::move(bodies);
  if (arguments.axis != "x" && arguments.axis != "y") {
    return bad_input("--axis: found " + in_quotes(arguments.axis) + ", wanted x or y");
  }
  how.lateral = arguments.axis == "x" ? replay::LateralAxis::kX : replay::LateralAxis::kY;
  how.from_step = arguments.from_step.value_or(0);
  return how;
}

}  // namespace tumble::tools
