#include "tools/arguments/transform_arguments.h"

#include <cmath>
#include <limits>

#include "src/base/text.h"
#include "src/math/grid.h"
#include "tools/arguments/numbers.h"
#include "tools/output/text.h"
#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

Result<sim::Vec3> parse_shift(const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::optional<double> x = parse_number(text.substr(0, comma));
  const std::optional<double> y = comma == std::string::npos ? std::nullopt : parse_number(text.substr(comma + 1));
  if (!x || !y || !(std::fabs(*x) <= sim::kPositionMax) || !(std::fabs(*y) <= sim::kPositionMax)) {
    return bad_input("--shift: found " + in_quotes(text) + ", wanted X,Y in metres, as in 1024,-512.5");
  }
  const sim::Vec3 shift(*x, *y, 0);
  const sim::Vec3 nearest = sim::PositionGrid::round(shift);
  if (nearest == shift) return shift;
  return bad_input("--shift: found " + in_quotes(text) +
                   ", wanted whole multiples of 2^-36 m, for only these shift exactly; the nearest is " +
                   exact(nearest.x()) + "," + exact(nearest.y()));
}

}  // namespace

void add_transform(Arguments& arguments, TransformArguments& target, Argument excluded) {
  arguments
      .option("--mirror", "AXIS", target.mirror,
              "Mirror the scene: x (x becomes -x), y, or diagonal (x and y change places)")
      .offers({"x", "y", "diagonal"})
      .excludes(excluded);
  arguments.option("--shift", "X,Y", target.shift, "Move the scene by X and Y metres").excludes(excluded);
  arguments
      .whole("--permute", "SEED", target.permute, 0, std::numeric_limits<std::int64_t>::max(),
             "Exchange the bodies' ids among them, by this seed")
      .excludes(excluded);
}

Result<sim::Transform> parse_transform(const TransformArguments& arguments) {
  sim::Transform transform;
  transform.mirror_x = arguments.mirror == "x";
  transform.mirror_y = arguments.mirror == "y";
  transform.swap_xy = arguments.mirror == "diagonal";
  if (!arguments.mirror.empty() && !transform.reflects()) {
    return bad_input("--mirror: found " + in_quotes(arguments.mirror) + ", wanted x, y or diagonal");
  }
  if (!arguments.shift.empty()) {
    const Result<sim::Vec3> shift = parse_shift(arguments.shift);
    if (!shift.ok()) return shift.error();
    transform.shift = *shift;
  }
  transform.permute = arguments.permute;
  return transform;
}

}  // namespace tumble::tools
