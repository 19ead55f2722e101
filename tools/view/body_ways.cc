#include "tools/view/body_ways.h"

#include <limits>

#include "replay/format/not_finite.h"

namespace tumble::tools {

void BodyWays::add(std::uint64_t step, const replay::BodyStates& states) {
  if (taken_++ % stride_ != 0) return;
  if (steps_.size() == kStepsMax) {                    // every second one goes
    for (std::size_t i = 1; 2 * i < kStepsMax; ++i) {  // from 1 on: a vector moved into itself would be empty
      steps_[i] = steps_[2 * i];
      places_[i] = std::move(places_[2 * i]);
    }
    steps_.resize(kStepsMax / 2);
    places_.resize(kStepsMax / 2);
    stride_ *= 2;
    if ((taken_ - 1) % stride_ != 0) return;
  }
  std::vector<float> places;
  places.reserve(3 * rows_.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    const std::size_t row = rows_.try_emplace(states.id[i], rows_.size()).first->second;
    if (places.size() < 3 * row + 3) places.resize(3 * row + 3, std::numeric_limits<float>::quiet_NaN());
    if (!replay::is_finite(states, i)) continue;
    for (int c = 0; c < 3; ++c) {
      places[3 * row + static_cast<std::size_t>(c)] = static_cast<float>(states.position[i][c]);
    }
  }
  steps_.push_back(step);
  places_.push_back(std::move(places));
}

BodyWays::Way BodyWays::way(sim::BodyId id) const {
  Way way;
  const auto found = rows_.find(id);
  if (found == rows_.end()) return way;
  way.step = steps_;
  for (const std::vector<float>& places : places_) {
    for (std::size_t c = 3 * found->second; c < 3 * found->second + 3; ++c) {
      way.at.push_back(c < places.size() ? places[c] : std::numeric_limits<float>::quiet_NaN());
    }
  }
  return way;
}

}  // namespace tumble::tools
