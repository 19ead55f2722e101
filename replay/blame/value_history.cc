#include "replay/blame/value_history.h"

#include <cmath>

namespace tumble::replay {
namespace {

// The last step up to k before which differs(value then) holds, or there was no body.
template <class Differs>
Result<StepFound> last_step(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field, Differs differs) {
  for (; k > steps.log().first_state(); --k) {
    const Status held = steps.has_step(k);  // state k may be a keyframe's, and the step itself lost
    if (!held.ok() && held.error().kind == ErrorKind::kDamaged) return StepFound{k, true};
    if (!held.ok()) return held.error();
    const Result<std::optional<BodyMotion>> before = steps.after(k - 1, body);
    if (!before.ok()) return before.error();
    if (!before->has_value() || differs((*before)->of(field))) return StepFound{k};
  }
  return StepFound{k};
}

}  // namespace

Result<double> value_after(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field) {
  const Result<std::optional<BodyMotion>> now = steps.after(k, body);
  if (!now.ok()) return now.error();
  return now->has_value() ? (*now)->of(field) : 0.0;
}

Result<StepFound> step_it_changed(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field) {
  const Result<double> value = value_after(steps, k, body, field);
  if (!value.ok()) return value.error();
  return last_step(steps, k, body, field, [&](double then) { return !same_value(then, *value); });
}

Result<StepFound> step_it_began(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field) {
  const Result<double> value = value_after(steps, k, body, field);
  if (!value.ok()) return value.error();
  if (*value == 0 || !std::isfinite(*value)) return step_it_changed(steps, k, body, field);
  // A comparison that is false for NaN: a value that was none is another.
  return last_step(steps, k, body, field,
                   [&](double then) { return !(std::fabs(then - *value) <= 0.5 * std::fabs(*value)); });
}

Result<StepFound> step_before_fall(StepsAgain& steps, std::uint64_t k, sim::BodyId body, std::size_t field,
                                   double fall) {
  Result<double> value = value_after(steps, k, body, field);
  if (!value.ok()) return value.error();
  double now = *value;
  return last_step(steps, k, body, field, [&](double then) {
    const bool falls = std::fabs((now - then) - fall) <= 1e-9;
    now = then;
    return !falls;
  });
}

}  // namespace tumble::replay
