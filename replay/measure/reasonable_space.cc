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
  if (ground_) low_.z() = std::min(low_.z(), 0.0);
  if (ground_ || !box.is_static) return;
  const double bottom = box.position.z() - reach.z();
  floor_ = floor_ == -kInfinity ? bottom : std::min(floor_, bottom);
}

void ReasonableSpace::pass(double dt, const sim::Vec3& gravity) {
  down_speed_ += (-gravity).cwiseMax(0.0) * dt;
  up_speed_ += gravity.cwiseMax(0.0) * dt;
  down_way_ += down_speed_ * dt;
  up_way_ += up_speed_ * dt;
  const double height = high_.z() - floor_;  // infinite without a floor: nothing is there to turn a fall aside
  if (!(height > 0 && height < kInfinity)) return;
  fall_way_ += std::min(down_speed_.z(), std::sqrt(2 * std::max(-gravity.z(), 0.0) * height)) * dt;
}

bool ReasonableSpace::holds(const sim::Vec3& centre, double way) const {
  if (!(centre.z() >= floor_)) return false;  // false for NaN
  const double reach = std::max(kReasonableDistance, (high_ - low_).maxCoeff()) + way;
  for (int k = 0; k < 3; ++k) {
    const double low = reach + down_way_[k] + (k < 2 ? fall_way_ : 0);
    const double high = reach + up_way_[k] + (k < 2 ? fall_way_ : 0);
    if (!(centre[k] >= low_[k] - low && centre[k] <= high_[k] + high)) return false;
  }
  return true;
}

}  // namespace tumble::replay
