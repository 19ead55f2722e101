#include "replay/measure/start_loads.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

#include "replay/measure/measure_overlap.h"
#include "src/base/text.h"
#include "tumble/sim/limits.h"

namespace tumble::replay {
namespace {

constexpr double kLyingOn = 1e-3;             // m, how far apart things that lie on one another may start
constexpr double kThesisRatio = 50;           // in substeps of kThesisSubstep
constexpr double kThesisSubstep = 1.0 / 480;  // s
constexpr double kTinyEdge = 1.5e-3, kTinyRatio = 1e7;
constexpr double kSmallEdge = 1.5e-2, kSmallRatio = 1e11;

}  // namespace

// Measured with unit cubes, of which the upper one weighs 1 to 10⁸ kg, at 1/60 s and 1/240 s with 1 to 128 substeps:
// the upper one sinks into the lower one by more than a tenth from 60 kg on in substeps of 1/480 s, from 25 kg in those
// of 1/240 s, from 500 kg in those of 1/960 s and 1/1920 s, from 2000 kg in those of 1/3840 s.
double StartLoads::thesis_ratio(double substeps) const {
  return std::max(1.0, kThesisRatio * kThesisSubstep * substeps / world_.dt);
}

// Method layered: measured with cubes and plates of 1 mm to 1 m under cubes of 1 mm to 100 m, in the middle and aside,
// with ratios up to 10¹²: cubes of 1 mm are shot away or pressed in from 10⁹ times their mass on, plates of 1 mm under
// a cube that stands aside at 10⁷ times even in substeps of 1/3840 s; cubes of 2 mm to 1 cm at 10¹²; from 2 cm on none.
double StartLoads::bearable_ratio(std::size_t light) const {
  if (world_.method == sim::Method::kThesis) return thesis_ratio(std::bit_floor(world_.substeps));
  const double edge = 2 * boxes_[light].half_extent.minCoeff();
  if (edge < kTinyEdge) return kTinyRatio;
  return edge < kSmallEdge ? kSmallRatio : std::numeric_limits<double>::infinity();
}

// Moved a little way along gravity, what lies on a body comes nearer to it by at least half of that way.
bool StartLoads::presses(std::size_t heavy, std::size_t light) const {
  const double size = sim::length(world_.gravity);
  if (!(size > 0)) return false;
  sim::BoxFrame moved = boxes_[heavy];
  moved.position = moved.position + world_.gravity * (kLyingOn / size);
  const double after = separation_of(moved, boxes_[light]);
  return after < 0 && separation_of(boxes_[heavy], boxes_[light]) - after >= kLyingOn / 2;
}

void StartLoads::look_at(std::size_t i, std::size_t j) {
  if (bodies_.is_static[i] != 0 || bodies_.is_static[j] != 0) return;
  const auto [light, heavy] = bodies_.mass[i] < bodies_.mass[j] ? std::pair(i, j) : std::pair(j, i);
  const double times = bodies_.mass[heavy] / bodies_.mass[light];
  if (!(times > bearable_ratio(light)) || !presses(heavy, light)) return;
  ++count_;
  if (times <= times_) return;
  heavy_ = heavy;
  light_ = light;
  times_ = times;
}

std::string StartLoads::remedy() const {
  std::string masses = "bring the masses closer together, or make one of the two static";
  if (world_.method != sim::Method::kThesis) return masses;
  for (std::uint32_t substeps = std::bit_floor(world_.substeps) * 2; substeps <= sim::kSubstepsMax; substeps *= 2) {
    if (thesis_ratio(substeps) >= times_)
      return "take substeps = " + std::to_string(substeps) + ", method layered, or masses closer together";
  }
  return "take method layered, or " + masses;
}

void StartLoads::add_to(std::vector<std::string>& out) const {
  if (count_ == 0) return;
  const bool is_thesis = world_.method == sim::Method::kThesis;
  std::string& line = out.emplace_back("body " + std::to_string(bodies_.id[heavy_]));
  line.append(" is ").append(significant(times_, 4)).append(" times as heavy as body ");
  line.append(std::to_string(bodies_.id[light_])).append(", on which it lies at the start: beyond ");
  line.append(significant(bearable_ratio(light_), 4)).append(" times the light one may be pressed flat");
  line.append(is_thesis ? " in method thesis with " + count_text(world_.substeps, "substep") + " of a step of " +
                              seconds_text(world_.dt)
                        : " or shot away, whatever dt and substeps");
  line.append("; ").append(remedy());
  if (count_ > 1) line.append("; " + count_text(count_ - 1, "more pair") + " likewise");
}

}  // namespace tumble::replay
