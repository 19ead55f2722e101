#include "replay/import/derived_motion.h"

#include <cctype>
#include <cmath>
#include <limits>

#include "src/math/trig.h"

namespace tumble::replay {
namespace {

sim::Quat turn_after(const sim::Quat& a, const sim::Quat& b) {
  return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
          a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

sim::Quat turn_about(int axis, double degrees) {
  const sim::SinCos half = sim::sin_cos_degrees(degrees / 2);
  return {half.cos, axis == 0 ? half.sin : 0, axis == 1 ? half.sin : 0, axis == 2 ? half.sin : 0};
}

}  // namespace

std::optional<EulerOrder> parse_euler(std::string_view text) {
  if (text.size() != 3) return std::nullopt;
  EulerOrder order;
  order.intrinsic = text[0] >= 'A' && text[0] <= 'Z';
  const char first = order.intrinsic ? 'X' : 'x';
  for (std::size_t k = 0; k < 3; ++k) {
    order.axes[k] = text[k] - first;
    if (order.axes[k] < 0 || order.axes[k] > 2 || (k > 0 && order.axes[k] == order.axes[k - 1])) return std::nullopt;
  }
  return order;
}

sim::Quat orientation_of(const EulerOrder& order, const std::array<double, 3>& degrees) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  sim::Quat q;
  for (std::size_t k = 0; k < 3; ++k) {
    if (!std::isfinite(degrees[k])) return {kNaN, kNaN, kNaN, kNaN};
    const sim::Quat turn = turn_about(order.axes[k], degrees[k]);
    q = order.intrinsic ? turn_after(q, turn) : turn_after(turn, q);
  }
  return q;
}

sim::Vec3 spin_between(const sim::Quat& from, const sim::Quat& to, double dt) {
  sim::Quat turn = turn_after(to, {from.w, -from.x, -from.y, -from.z});
  if (turn.w < 0) turn = {-turn.w, -turn.x, -turn.y, -turn.z};
  const sim::Vec3 axis = {turn.x, turn.y, turn.z};
  const double sine = std::sqrt(axis.x() * axis.x() + axis.y() * axis.y() + axis.z() * axis.z());
  if (sine == 0) return {0, 0, 0};
  return axis * (2 * std::atan2(sine, turn.w) / (sine * dt));
}

void DerivedMotion::derive(sim::BodyId id, std::uint64_t step, double dt, bool velocity, bool spin,
                           EngineState& state) {
  const auto known = before_.find(id);
  if (known != before_.end() && known->second.step + 1 == step && dt > 0) {
    const Before& before = known->second;
    if (velocity) state.velocity = (state.position - before.position) / dt;
    if (spin) state.spin = spin_between(before.orientation, state.orientation, dt);
  }
  before_[id] = {step, state.position, state.orientation};
}

}  // namespace tumble::replay
