#include "replay/measure/reasonable_space.h"

#include <algorithm>
#include <cmath>

namespace tumble::replay {

ReasonableSpace::ReasonableSpace(bool ground)
    : ground_(ground),
      floor_(ground ? 0 : -kInfinity),
      low_(kInfinity, kInfinity, kInfinity),
      high_(-kInfinity, -kInfinity, -kInfinity) {}

// A box reaches along a world axis by the sum of its half edges' shadows on it: Σ half_k |axis_k|.
void ReasonableSpace::add(const sim::BoxDef& box) {
  const sim::Axes axes = sim::axes_of(box.orientation);
  const sim::Vec3 half = box.size / 2;
  const sim::Vec3 reach =
      (axes[0].cwiseAbs() * half.x() + axes[1].cwiseAbs() * half.y()) + axes[2].cwiseAbs() * half.z();
  if (!box.position.allFinite() || !reach.allFinite()) return;  // a lost body widens nothing
  low_ = low_.cwiseMin(box.position - reach);
  high_ = high_.cwiseMax(box.position + reach);
  if (!box.is_static) add_speed(sim::length(box.velocity));
  if (ground_ || !box.is_static) return;
  const double bottom = box.position.z() - reach.z();
  floor_ = floor_ == -kInfinity ? bottom : std::min(floor_, bottom);
}

void ReasonableSpace::add_speed(double speed) {
  if (std::isfinite(speed)) fastest_ = std::max(fastest_, speed);
}

bool ReasonableSpace::holds(const sim::Vec3& centre) const {
  if (!(centre.z() >= floor_)) return false;  // false for NaN
  const double reach = std::max(kReasonableDistance, (high_ - low_).maxCoeff()) + way_;
  for (int k = 0; k < 3; ++k) {
    if (!(centre[k] >= low_[k] - reach && centre[k] <= high_[k] + reach)) return false;
  }
  return true;
}

}  // namespace tumble::replay
