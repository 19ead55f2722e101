#include "src/world/lift_cost.h"

#include <algorithm>
#include <cmath>

#include "src/math/grid.h"

namespace tumble::sim {

LiftCost pay_for_lift(const Vec3& velocity, const Vec3& displacement, const Vec3& gravity, const Vec3& up) {
  const double pumped = -dot(gravity, displacement);  // J/kg
  if (pumped <= 0) return {velocity};
  const double rise = dot(velocity, up);
  const double left = std::sqrt(std::max(0.0, rise * rise - 2 * pumped));
  const double new_rise = rise < 0 ? -left : left;
  const Vec3 slower = plus_zero(velocity + VelocityGrid::round(Vec3(up * (new_rise - rise))));
  const double unpaid = std::max(0.0, pumped - 0.5 * (rise * rise));
  return {slower, 0.5 * (dot(velocity, velocity) - dot(slower, slower)), unpaid};
}

}  // namespace tumble::sim
