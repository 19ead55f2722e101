#include "tools/live/measurement.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "src/render/scene/camera_moves.h"

namespace tumble::tools {
namespace {

constexpr double kWarmUp = 1, kThrowEvery = 0.5;  // s
constexpr double kTurn = 12;                      // degrees a second

double mean(const std::vector<double>& values) {
  if (values.empty()) return 0;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double at_share(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Json times(const std::vector<double>& seconds) {
  return {{"mean", mean(seconds)}, {"p95", at_share(seconds, 0.95)}, {"most", at_share(seconds, 1)}};
}

}  // namespace

void Measurement::play(Hand& hand, ViewState& view, double now_s) {
  render::orbit(view.camera, kTurn * (now_s - turned_at_), 0, true);
  turned_at_ = now_s;
  if (now_s - thrown_at_ < kThrowEvery) return;
  thrown_at_ = now_s;
  const double side = 0.5 + 0.08 * static_cast<double>(static_cast<int>(throws_++ % 5) - 2);
  hand.act({side, 0.5}, 0.6);
}

void Measurement::count(const replay::LiveFrame& frame, double draw_seconds, double now_s) {
  if (now_s < kWarmUp) return;
  if (begin_ < 0) {
    begin_ = now_s;
    simulated_begin_ = frame.time;
    first_step_ = frame.step;
  } else {
    frame_seconds_.push_back(now_s - end_);
    draw_seconds_.push_back(draw_seconds);
    step_seconds_.push_back(frame.step_seconds);
  }
  end_ = now_s;
  simulated_end_ = frame.time;
  last_step_ = frame.step;
}

Json Measurement::json(const Hand& hand) const {
  const double length = end_ - begin_;
  const Hand::Delay& delay = hand.delay();
  Json json;
  json["seconds"] = length;
  json["frames"] = frame_seconds_.size();
  json["frames_per_second"] = length > 0 ? static_cast<double>(frame_seconds_.size()) / length : 0;
  json["frame_seconds"] = times(frame_seconds_);
  json["draw_seconds"] = times(draw_seconds_);
  json["step_seconds"] = times(step_seconds_);
  json["steps_per_second"] = length > 0 ? static_cast<double>(last_step_ - first_step_) / length : 0;
  json["simulated_per_second"] = length > 0 ? (simulated_end_ - simulated_begin_) / length : 0;
  json["inputs"] = delay.inputs;
  json["input_frames"] = {
      {"mean", delay.inputs > 0 ? static_cast<double>(delay.frames) / static_cast<double>(delay.inputs) : 0},
      {"most", delay.most}};
  return json;
}

}  // namespace tumble::tools
