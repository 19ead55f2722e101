#include "tools/commands/session_stepper.h"

#include <algorithm>
#include <span>
#include <thread>

#include "tumble/sim/limits.h"

namespace tumble::tools {
namespace {

constexpr double kLongestStep = 4;  // frames

}  // namespace

SessionStepper::SessionStepper(replay::Recorder& recorder, const RealTime& realtime) : recorder_(recorder) {
  if (!realtime.on) return;
  const double frame = recorder.world().state().def.dt;
  clock_.emplace(frame, std::min(sim::kDtMax, realtime.longest_step.value_or(kLongestStep * frame)), elapsed_s());
}

Status SessionStepper::step() {
  if (!clock_) return recorder_.step();
  std::this_thread::sleep_until(begin_ + std::chrono::duration<double>(clock_->due()));
  const sim::Command dt = sim::SetDt{clock_->begin(elapsed_s())};
  Status status = recorder_.step(std::span(&dt, 1));
  clock_->end(elapsed_s());
  return status;
}

double SessionStepper::elapsed_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

std::optional<replay::Frames> SessionStepper::frames() const {
  return clock_ ? std::optional(clock_->frames()) : std::nullopt;
}

}  // namespace tumble::tools
