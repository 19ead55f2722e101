#include "src/scenes/read_inputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "src/scenes/read_bodies.h"
#include "src/scenes/rules.h"

namespace tumble::scenes {
namespace {

sim::BodyId read_target(TableReader& reader) {
  return reader.required_integer("id", kIdRule, "the id of the body it is meant for");
}

sim::Command read_throw(TableReader& reader, const sim::Material& scene_material) {
  return sim::Throw{read_box(reader, scene_material)};
}

sim::Command read_push(TableReader& reader, const sim::Material&) {
  sim::Push push;
  push.id = read_target(reader);
  push.impulse = reader.required_vector("impulse", kImpulseRule, "three components in N·s");
  push.at_centre = !reader.has("at");
  push.at = reader.vector("at", push.at, kPositionRule);
  return push;
}

sim::Command read_remove(TableReader& reader, const sim::Material&) { return sim::Remove{read_target(reader)}; }

sim::Command read_wake(TableReader& reader, const sim::Material&) { return sim::Wake{read_target(reader)}; }

sim::Command read_set_velocity(TableReader& reader, const sim::Material&) {
  sim::SetVelocity set;
  set.id = read_target(reader);
  set.velocity = reader.required_vector("velocity", kVelocityRule, "three components in m/s");
  set.spin = reader.vector("spin", set.spin, kSpinRule);
  return set;
}

sim::Command read_set_gravity(TableReader& reader, const sim::Material&) {
  return sim::SetGravity{reader.required_vector("gravity", kGravityRule, "three components in m/s²")};
}

sim::Command read_set_dt(TableReader& reader, const sim::Material&) {
  return sim::SetDt{reader.required_number("dt", kDtRule, "the length of the steps from here on, in s")};
}

using CommandReader = sim::Command (*)(TableReader& reader, const sim::Material& scene_material);
// In the order of sim::kCommandNames.
constexpr std::array<CommandReader, sim::kCommandNames.size()> kCommandReaders = {
    read_throw, read_push, read_remove, read_wake, read_set_velocity, read_set_gravity, read_set_dt};

// The step of an input; `late` if it is one that a shortened session leaves out.
std::uint64_t read_step(TableReader& reader, const InputClock& clock, bool& late) {
  const bool by_time = reader.has("time");
  if (reader.has("step") == by_time) {
    reader.fail(by_time ? "time" : "step", by_time ? "either step or time; remove one" : "a step or a time");
    return 1;
  }
  const char* key = by_time ? "time" : "step";
  const std::uint64_t step =
      by_time ? 1 + static_cast<std::uint64_t>(std::round(reader.required_number("time", kSecondsRule) / clock.dt))
              : reader.required_integer("step", kStepsRule);
  late = step > clock.steps;
  if (late && !clock.steps_overridden) {
    const std::string last = std::to_string(clock.steps);
    reader.fail(key, by_time ? "a time before the end (it means step " + std::to_string(step) + ", the last one is " +
                                   last + ")"
                             : "a step from 1 to the last one, " + last);
  }
  return step;
}

// The bodies that exist as the inputs are applied one by one: those of the scene and those thrown in.
class Census {
 public:
  explicit Census(const std::vector<sim::BoxDef>& boxes) : boxes_(boxes) {}

  // Why a body cannot be the target of an input now; empty if it can.
  std::string missing(sim::BodyId id) const {
    if (removed_.contains(id))
      return "a body that exists (removed before step " + std::to_string(removed_.at(id)) + ")";
    if (thrown_.contains(id) || box(id)) return {};
    return "the id of a body that exists by then";
  }
  [[nodiscard]] bool is_static(sim::BodyId id) const {
    const auto thrown = thrown_.find(id);
    if (thrown != thrown_.end()) return thrown->second;
    const sim::BoxDef* found = box(id);
    return found && found->is_static;
  }
  void add(const sim::BoxDef& box) { thrown_.emplace(box.id, box.is_static); }
  void remove(sim::BodyId id, std::uint64_t step) { removed_.emplace(id, step); }

 private:
  [[nodiscard]] const sim::BoxDef* box(sim::BodyId id) const {
    const auto at = std::lower_bound(boxes_.begin(), boxes_.end(), id,
                                     [](const sim::BoxDef& box, sim::BodyId wanted) { return box.id < wanted; });
    return at != boxes_.end() && at->id == id ? &*at : nullptr;
  }

  const std::vector<sim::BoxDef>& boxes_;
  std::map<sim::BodyId, bool> thrown_;  // is it static?
  std::map<sim::BodyId, std::uint64_t> removed_;
};

// Applies one input to the list of living bodies. Returns the reason why the input is wrong, or nothing.
struct Follow {
  Census& census;
  std::uint64_t step;

  [[nodiscard]] std::string moving(sim::BodyId id) const {
    std::string wrong = census.missing(id);
    if (wrong.empty() && census.is_static(id)) wrong = "a body that can move; this one is static";
    return wrong;
  }
  std::string operator()(const sim::Throw& input) const {
    census.add(input.box);
    return {};
  }
  std::string operator()(const sim::Push& input) const { return moving(input.id); }
  std::string operator()(const sim::Wake& input) const { return moving(input.id); }
  std::string operator()(const sim::SetVelocity& input) const { return moving(input.id); }
  std::string operator()(const sim::Remove& input) const {
    std::string wrong = census.missing(input.id);
    if (wrong.empty()) census.remove(input.id, step);
    return wrong;
  }
  std::string operator()(const sim::SetGravity&) const { return {}; }
  std::string operator()(const sim::SetDt&) const { return {}; }
};

std::string target_text(const sim::Command& command) {
  return std::visit(
      [](const auto& input) {
        if constexpr (requires { input.id; }) return std::to_string(input.id);
        return std::string();
      },
      command);
}

}  // namespace

PendingInput read_input(TableReader& reader, std::uint32_t table, const InputClock& clock,
                        const sim::Material& scene_material) {
  PendingInput input;
  if (!reader.has("kind")) {
    reader.problem().report(
        reader.place(), "[[input]] key \"kind\": " +
                            found_wanted("none", list_text({sim::kCommandNames.begin(), sim::kCommandNames.end()})));
    return input;
  }
  input.timed.step = read_step(reader, clock, input.late);
  const std::size_t kind = reader.required_choice("kind", sim::kCommandNames);
  input.timed.command = kCommandReaders[kind](reader, scene_material);
  if (auto* thrown = std::get_if<sim::Throw>(&input.timed.command)) {
    thrown->box.origin = {sim::Origin::Kind::kInput, table, 0, 0};
  }
  input.place = reader.place("id");
  reader.finish();
  return input;
}

std::vector<sim::TimedCommand> check_inputs(std::vector<PendingInput> inputs, const std::vector<sim::BoxDef>& boxes,
                                            Problem& problem) {
  std::stable_sort(inputs.begin(), inputs.end(),
                   [](const PendingInput& a, const PendingInput& b) { return a.timed.step < b.timed.step; });
  Census census(boxes);
  std::vector<sim::TimedCommand> commands;
  for (PendingInput& input : inputs) {
    const std::string wanted = std::visit(Follow{census, input.timed.step}, input.timed.command);
    if (!wanted.empty()) {
      problem.report(input.place, "[[input]] key \"id\": " + found_wanted(target_text(input.timed.command), wanted));
    }
    if (!input.late) commands.push_back(std::move(input.timed));
  }
  return commands;
}

}  // namespace tumble::scenes
