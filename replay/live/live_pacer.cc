#include "replay/live/live_pacer.h"

#include <algorithm>

#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr double kLongestStep = 4;  // frames, as in `record --realtime`

// Slow motion takes as many steps a second as the scene asks for, and shorter ones: the picture stays smooth. Even
// steps keep their length, so they must come more rarely.
double period_of(double dt_s, const Pace& pace) { return pace.even ? dt_s / pace.speed : dt_s; }

}  // namespace

LivePacer::LivePacer(double dt_s, const Pace& pace, double now_s)
    : dt_(dt_s), pace_(pace), clock_(period_of(dt_s, pace), kLongestStep * period_of(dt_s, pace), now_s) {
  SIM_CHECK(pace.speed >= kSpeedLeast && pace.speed <= 1, pace.speed);
}

double LivePacer::begin(double now_s) {
  const double passed = clock_.begin(now_s);
  return std::clamp(pace_.even ? dt_ : passed * pace_.speed, sim::kDtMin, sim::kDtMax);
}

}  // namespace tumble::replay
