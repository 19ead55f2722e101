#include "src/layered/find/meeting_time.h"

#include <algorithm>
#include <bit>

#include "src/collide/box_pair.h"
#include "src/math/grid.h"

namespace tumble::sim {
namespace {

constexpr int kAdvancesMax = 16;    // one for each axis
constexpr double kTogether = 1e-9;  // m

}  // namespace

BoxFrame moved_on(const BoxFrame& b, const Vec3& velocity, double time_s) {
  BoxFrame moved = b;
  moved.position += PositionGrid::round(Vec3(velocity * time_s));
  return moved;
}

double meeting_time(const BoxFrame& a, const BoxFrame& b, const Vec3& velocity, double dt_s) {
  double time = 0;
  for (int advance = 0; advance < kAdvancesMax && time < dt_s; ++advance) {
    const BoxFrame there = moved_on(b, velocity, time);
    const BoxPair boxes(a, there);
    const BestAxes apart = boxes.best(kFaces | kEdges);
    if (apart.axes == 0 || apart.separation <= kTogether) return time;
    double wait = 0;
    for (unsigned rest = apart.axes; rest != 0; rest &= rest - 1) {
      const double closing = -dot(velocity, boxes.normal(std::countr_zero(rest)));
      if (closing <= 0) return dt_s;
      wait = std::max(wait, apart.separation / closing);
    }
    time += wait;
  }
  return time;
}

}  // namespace tumble::sim
