#include "tests/trial/random_sessions.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "replay/log/byte_memory.h"
#include "src/base/check.h"
#include "tumble/replay/body_states.h"
#include "tumble/replay/log_writer.h"
#include "tumble/replay/session.h"
#include "tumble/sim/step.h"

namespace tumble::trial {
namespace {

using sim::WorldState;

constexpr std::uint64_t kStepsMin = 3, kStepsMore = 18, kBoxesMax = 4, kInputsMax = 4, kAFew = 4;

sim::BoxDef random_box(sim::BodyId id, Dice& dice) {
  sim::BoxDef box;
  box.id = id;
  box.size = {dice.between(0.5, 1.5), dice.between(0.5, 1.5), dice.between(0.5, 1.5)};
  box.position = {dice.between(-1, 1), dice.between(-1, 1), 0.5 + 1.2 * static_cast<double>(id)};
  box.velocity = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-3, 1)};
  box.spin = {dice.between(-1, 1), 0, 0};
  box.mass = dice.between(0.5, 4);
  return box;
}

sim::Command random_input(sim::BodyId id, Dice& dice) {
  switch (dice.below(4)) {
    case 0:
      return sim::Push{id, {dice.between(-1, 1), 0, dice.between(0, 2)}, true, {0, 0, 0}};
    case 1:
      return sim::SetVelocity{id, {0, dice.between(-1, 1), 1}, {0, 0, 1}};
    case 2:
      return sim::SetGravity{{0, 0, dice.between(-12, -8)}};
    default:
      return sim::SetDt{dice.between(0.005, 0.02)};
  }
}

/// Columns of doubles of a state, visible ones first.
std::vector<std::vector<double>*> columns_of(sim::Bodies& b) {
  return {&b.position.x,    &b.position.y,      &b.position.z, &b.orientation.w, &b.orientation.x, &b.orientation.y,
          &b.orientation.z, &b.velocity.x,      &b.velocity.y, &b.velocity.z,    &b.spin.x,        &b.spin.y,
          &b.spin.z,        &b.low_energy_time, &b.mass,       &b.inertia.x,     &b.friction,      &b.restitution};
}
constexpr std::size_t kVisible = 13;

double changed(double value, Dice& dice) {
  switch (dice.below(5)) {
    case 0:
      return -value;  // −0.0 of 0.0
    case 1:
      return std::numeric_limits<double>::quiet_NaN();
    case 2:
      return value + 1e-7;
    default:
      return std::nextafter(value, 1e9);
  }
}

bool same_double(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

bool same_columns(const std::vector<double>& a, const std::vector<double>& b) {
  return std::ranges::equal(a, b, same_double);
}

bool same_visible(const WorldState& a, const WorldState& b) {
  replay::BodyStates in_a, in_b;
  replay::copy_visible(a.bodies, in_a);
  replay::copy_visible(b.bodies, in_b);
  return replay::same_bits(in_a, in_b);
}

bool same_counters(const sim::StepCounters& a, const sim::StepCounters& b) {
  return a.pairs == b.pairs && a.contacts == b.contacts && a.substeps == b.substeps &&
         same_double(a.kinetic, b.kinetic) && same_double(a.potential, b.potential) &&
         same_double(a.inputs, b.inputs) && same_double(a.removed, b.removed);
}

std::string change_column(RandomSession& session, std::size_t from, Dice& dice) {
  const auto columns = columns_of(session.steps[from].after.bodies);
  const std::size_t column = dice.below(columns.size()), row = dice.below(columns[column]->size());
  const bool stays = column >= kVisible;  // a property that a body has for good
  double& first = (*columns[column])[row];
  first = stays ? first + 0.125 : changed(first, dice);
  for (std::size_t k = from + 1; stays && k < session.steps.size(); ++k) {
    (*columns_of(session.steps[k].after.bodies)[column])[row] = first;
  }
  return "column " + std::to_string(column) + " from step " + std::to_string(from + 1) + " on";
}

std::string negate_rotation(WorldState& state, Dice& dice) {
  const std::size_t row = dice.below(state.bodies.size());
  const sim::Quat q = state.bodies.orientation[row];
  state.bodies.orientation.set(row, {-q.w, -q.x, -q.y, -q.z});
  return "another sign of a rotation";
}

std::string change_counter(sim::StepCounters& counters, Dice& dice) {
  switch (dice.below(4)) {
    case 0:
      ++counters.pairs;
      return "pairs";
    case 1:
      ++counters.contacts;
      return "contacts";
    case 2:
      counters.kinetic = changed(counters.kinetic, dice);
      return "kinetic energy";
    default:
      counters.removed = changed(counters.removed, dice);
      return "removed energy";
  }
}

}  // namespace

std::uint64_t Dice::word() {  // xorshift64*
  state_ ^= state_ >> 12;
  state_ ^= state_ << 25;
  state_ ^= state_ >> 27;
  return (state_ * 0x2545f4914f6cdd1d) >> 8;
}

double Dice::between(double low, double high) { return low + (high - low) * static_cast<double>(below(1024)) / 1024; }

RandomSession make_session(Dice& dice) {
  RandomSession made;
  made.scene.name = "random";
  made.scene.world.method = dice.below(2) == 0 ? sim::Method::kThesis : sim::Method::kLayered;
  made.scene.steps = kStepsMin + dice.below(kStepsMore);
  const std::uint64_t boxes = 1 + dice.below(kBoxesMax);
  for (std::uint64_t i = 1; i <= boxes; ++i) made.scene.boxes.push_back(random_box(i, dice));
  for (std::uint64_t i = dice.below(kInputsMax); i > 0; --i) {
    made.scene.inputs.push_back({1 + dice.below(made.scene.steps), random_input(1 + dice.below(boxes), dice)});
  }
  std::ranges::stable_sort(made.scene.inputs, {}, &sim::TimedCommand::step);
  Result<replay::Session> session = replay::Session::start(made.scene);
  SIM_CHECK(session.ok(), made.scene.steps);
  made.start = session->world().state();
  sim::PhaseHashes hashes;
  for (std::uint64_t k = 1; k <= made.scene.steps; ++k) {
    hashes.clear();
    const Result<replay::TakenStep> taken = session->step({}, &hashes);
    SIM_CHECK(taken.ok(), k);
    made.steps.push_back({taken->dt,
                          {taken->inputs.begin(), taken->inputs.end()},
                          hashes.words(),
                          taken->counters,
                          session->world().state()});
  }
  return made;
}

std::string change(RandomSession& session, Dice& dice) {
  const std::size_t k = dice.below(session.steps.size());
  RandomStep& step = session.steps[k];
  const std::string where = " in step " + std::to_string(k + 1);
  switch (dice.below(8)) {
    case 0:
      step.dt = changed(step.dt, dice);
      return "dt" + where;
    case 1:
      step.inputs.emplace_back(sim::Wake{1 + dice.below(kAFew)});
      return "one more input" + where;
    case 2:
      step.words[dice.below(step.words.size())] ^= 1;
      return "a phase word" + where;
    case 3:
      return change_counter(step.counters, dice) + where;
    case 4:
      return negate_rotation(step.after, dice) + where;
    case 5:
      session.steps.resize(k + 1);
      return "the end, after step " + std::to_string(k + 1);
    default:
      return change_column(session, k, dice);
  }
}

std::vector<std::byte> log_of(const RandomSession& session, std::uint64_t chunk, const replay::StatesMode& states) {
  auto file = std::make_shared<std::vector<std::byte>>();
  replay::LogHeader header = replay::header_for(session.scene);
  header.states = states;
  auto writer = replay::LogWriter::create(std::make_unique<replay::MemoryByteSink>(file, "b"), header, session.start);
  SIM_CHECK(writer.ok(), chunk);
  for (std::size_t k = 0; k < session.steps.size(); ++k) {
    const RandomStep& step = session.steps[k];
    Status ok = (*writer)->append({step.dt, step.inputs, step.words, step.counters}, step.after);
    if (ok.ok() && (k + 1) % chunk == 0) ok = (*writer)->flush(step.after);
    SIM_CHECK(ok.ok(), k);
  }
  SIM_CHECK((*writer)->finish().ok(), chunk);
  return *file;
}

bool equal_bits(const RandomSession& a, const RandomSession& b) {
  if (a.steps.size() != b.steps.size() || !same_visible(a.start, b.start)) return false;
  for (std::size_t k = 0; k < a.steps.size(); ++k) {
    const RandomStep &one = a.steps[k], &other = b.steps[k];
    if (!same_double(one.dt, other.dt) || one.inputs != other.inputs || one.words != other.words ||
        !same_counters(one.counters, other.counters) || !same_visible(one.after, other.after)) {
      return false;
    }
  }
  return true;
}

bool equal_hidden(const RandomSession& a, std::uint64_t chunk_a, const RandomSession& b, std::uint64_t chunk_b) {
  for (std::size_t k = 1; k < std::min(a.steps.size(), b.steps.size()); ++k) {
    if (k % chunk_a != 0 || k % chunk_b != 0) continue;
    WorldState one = a.steps[k - 1].after, other = b.steps[k - 1].after;
    const auto in_a = columns_of(one.bodies), in_b = columns_of(other.bodies);
    for (std::size_t c = kVisible; c < in_a.size(); ++c) {
      if (!same_columns(*in_a[c], *in_b[c])) return false;
    }
  }
  return true;
}

}  // namespace tumble::trial
