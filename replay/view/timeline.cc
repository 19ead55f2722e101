#include "replay/view/timeline.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "replay/format/not_finite.h"
#include "replay/view/contact_points.h"
#include "src/world/scratch.h"

namespace tumble::replay {
namespace {

using Pairs = std::vector<std::pair<sim::BodyId, sim::BodyId>>;

// A contact that sleeps goes on touching.
void add_sleeping(const sim::World& world, Pairs& pairs) {
  if (world.state().def.method == sim::Method::kThesis) return;
  const auto& ids = world.bodies().id;
  for (const sim::Manifold& manifold : world.scratch().manifolds) {
    if (!manifold.asleep) continue;
    const sim::BodyId b = ids[manifold.b];
    const sim::BodyId a = manifold.a == sim::kGround ? b : ids[manifold.a];
    pairs.emplace_back(std::min(a, b), manifold.a == sim::kGround ? 0 : std::max(a, b));
  }
}

Pairs touching(const sim::World& world) {
  Pairs pairs;
  for (const ContactPoint& point : contact_points(world)) {
    if (point.impulse > 0 || point.depth >= 0) pairs.emplace_back(point.a, point.b.value_or(0));
  }
  add_sleeping(world, pairs);
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

/// The number of pairs of `a` that `b` lacks.
std::uint32_t lacking(const Pairs& a, const Pairs& b) {
  Pairs only;
  std::ranges::set_difference(a, b, std::back_inserter(only));
  return static_cast<std::uint32_t>(only.size());
}

// The largest value of a channel in a step; NaN where there is none.
double largest_of(const ChannelValues& values, ChannelKind kind) {
  double largest = kNotANumber;
  for (std::size_t row = 0; row < values.size(); ++row) {
    const double value = number_of(values.value(row, kind));
    if (!(largest >= value) && !std::isnan(value)) largest = value;
  }
  return largest;
}

}  // namespace

std::vector<std::size_t> channel_columns(const LogHeader& header) {
  std::vector<std::size_t> columns;
  const std::vector<Channel>& channels = header.declared.channels;
  for (const std::size_t c : listed_order(channels)) {
    if (is_number(channels[c].type.kind)) columns.push_back(c);
  }
  return columns;
}

TimelineScan::TimelineScan(LogReader& log, std::vector<ViewedBound> bounds)
    : log_(&log), channels_(channel_columns(log.header())), next_(log.first_state()) {
  source_.emplace(log);
  bounds_.emplace(log.header(), std::move(bounds));
}

void TimelineScan::follow(LogReader& log) {
  log_ = &log;
  record_ = nullptr;
  source_.emplace(log);
}

std::vector<sim::Command> TimelineScan::inputs() const {
  return record_ == nullptr ? std::vector<sim::Command>() : record_->inputs;
}

void TimelineScan::measure(const StepRecord& record, TimelineRow& row) {
  const BodyStates& states = record.states;
  row.bodies = static_cast<std::uint32_t>(states.size());
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states.frozen[i] != 0) ++row.frozen;
    if (!is_finite(states, i)) {
      ++row.not_finite;
      continue;
    }
    const double speed = sim::length(states.velocity[i]);
    if (speed > row.speed_max) {
      row.speed_max = speed;
      row.speed_body = states.id[i];
    }
    row.height_max = std::max(row.height_max, states.position.z[i]);
  }
  if (!meter_) meter_.emplace(log_->header().scene, states, MeasureOptions(), log_->bodies());
  row.overlap = row.not_finite > 0 ? kNotANumber : meter_->overlap_max(states);
}

TimelineRow TimelineScan::next() {
  TimelineRow row;
  row.step = next_++;
  const Result<const StepRecord*> record = source_->read(row.step);
  record_ = record.ok() ? *record : nullptr;
  row.read = record.ok();
  why_not_ = record.ok() ? "" : record.error().message;
  if (!record.ok()) {
    bounds_.reset();
    time_ += log_->header().scene.world.dt;  // the best guess there is
    row.time = time_;
    return row;
  }
  if (row.step > log_->first_state()) time_ += record_->dt;
  row.time = time_;
  row.kinetic = record_->counters.kinetic;
  row.potential = record_->counters.potential;
  row.inputs = record_->counters.inputs;
  // Our steps count theirs; another engine tells them one by one, or none.
  row.contacts =
      log_->header().engine ? static_cast<std::uint32_t>(record_->extras.contacts.size()) : record_->counters.contacts;
  if (meter_) {
    for (const sim::Command& input : record_->inputs) meter_->apply(input);
  }
  for (const std::size_t c : channels_) {
    const ChannelValues& values = record_->extras.values(c);
    const ChannelKind kind = log_->header().declared.channels[c].type.kind;
    row.channels.push_back(largest_of(values, kind));
  }
  measure(*record_, row);
  if (row.not_finite == 0) row.kinetic = meter_->kinetic_by_shapes(record_->states).value_or(row.kinetic);
  if (row.step == log_->first_state() && row.not_finite == 0) {  // no step led here, so nothing counted its energy
    const StateMeter::StartEnergy energy = meter_->start_energy();
    row.kinetic = energy.kinetic;
    row.potential = energy.potential;
  }
  if (bounds_) row.bounds = bounds_->add(*record_);
  return row;
}

void ContactScan::follow(LogReader& log) {
  log_ = &log;
  player_.reset();
}

Result<ContactScan::Row> ContactScan::next() {
  if (!player_) {
    Result<Player> player = Player::at(*log_, taken_);
    if (!player.ok()) return player.error();
    player_ = *std::move(player);
  }
  if (Status ok = player_->step_to(taken_ + 1); !ok.ok()) return ok.error();
  ++taken_;
  Pairs now = touching(player_->world());
  const Row row = {taken_, lacking(now, touching_), lacking(touching_, now)};
  touching_ = std::move(now);
  return row;
}

}  // namespace tumble::replay
