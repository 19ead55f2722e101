#include "src/math/lift_cost.h"

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
  // Built where it stays: a copy would wait for the three stores before it, and the next body with it.
  LiftCost cost{plus_zero(velocity + VelocityGrid::round(Vec3(up * (new_rise - rise))))};
  cost.removed = 0.5 * (dot(velocity, velocity) - dot(cost.velocity, cost.velocity));
  cost.unpaid = std::max(0.0, pumped - 0.5 * (rise * rise));
  return cost;
}

}  // namespace tumble::sim
