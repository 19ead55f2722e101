#include "golden/hunt/judge/same_bits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <utility>

#include "golden/hunt/scene/neighbours.h"
#include "replay/log/byte_memory.h"
#include "src/base/text.h"
#include "tumble/replay/player.h"
#include "tumble/replay/recorder.h"
#include "tumble/sim/step.h"
#include "tumble/threads/worker_threads.h"

namespace tumble::hunt {
namespace {

using sim::BodyIndex;
using sim::image_of;
using sim::Transform;

constexpr std::array kFields = {"position x",    "position y",    "position z", "orientation w",   "orientation x",
                                "orientation y", "orientation z", "velocity x", "velocity y",      "velocity z",
                                "spin x",        "spin y",        "spin z",     "low energy time", "frozen"};
using Values = std::array<double, kFields.size()>;

Values values_of(const sim::Bodies& bodies, BodyIndex i, const Transform& t) {
  const sim::Vec3 x = t.point(bodies.position[i]), v = t.vector(bodies.velocity[i]);
  const sim::Vec3 w = t.axial_vector(bodies.spin[i]);
  const sim::Quat q = t.orientation(bodies.orientation[i]);
  return {x.x(),
          x.y(),
          x.z(),
          q.w,
          q.x,
          q.y,
          q.z,
          v.x(),
          v.y(),
          v.z(),
          w.x(),
          w.y(),
          w.z(),
          bodies.low_energy_time[i],
          static_cast<double>(bodies.frozen[i])};
}

constexpr double kOthersNear = 1000;  // m

constexpr unsigned kThreads = 3;
constexpr std::size_t kThreadedSteps = 2;

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

// Takes the quaternion of the two that stand for the orientation found which is nearer to the one wanted.
void turn_towards(const Values& wanted, Values& found) {
  constexpr std::size_t kFirst = 3, kEnd = 7;  // the orientation in kFields
  double cosine = 0;
  for (std::size_t k = kFirst; k < kEnd; ++k) cosine += wanted[k] * found[k];
  for (std::size_t k = kFirst; k < kEnd && cosine < 0; ++k) found[k] = -found[k];
}

Judgement failed(std::uint64_t step, const std::string& message) {
  return broken(step, 0, "the other session ends there: " + message);
}

// The step as its session took it, against the trace.
Judgement compare_step(const Trace& trace, std::size_t k, const sim::WorldState& state,
                       const std::vector<std::uint64_t>& words, const sim::StepCounters& counters) {
  return compare_steps(trace.scene.world.method, k + 1, {trace.after(k), trace.steps[k].words, trace.steps[k].counters},
                       {state, words, counters});
}

// Another session of the trace's scene, step by step.
Judgement compare_session(const Trace& trace, replay::Session& session) {
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    sim::PhaseHashes hashes;
    const Result<replay::TakenStep> taken = session.step({}, &hashes);
    if (!taken.ok()) return failed(k + 1, taken.error().message);
    Judgement one = compare_step(trace, k, session.world().state(), hashes.words(), taken->counters);
    if (one.outcome != Outcome::kHeld) return one;
  }
  return held();
}

}  // namespace

std::optional<ValueDifference> first_difference(const sim::Bodies& original, const sim::Bodies& image,
                                                const Transform& transform, const sim::IdMap& ids, Signs signs,
                                                Others others) {
  for (BodyIndex i = 0; i < original.size(); ++i) {
    const auto j = image.find(image_of(original.id[i], ids));
    if (!j) return ValueDifference{original.id[i], "body", 1, 0};
    const Values wanted = values_of(original, i, transform);
    Values found = values_of(image, *j, {});
    if (signs == Signs::kAlike) turn_towards(wanted, found);
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      if (signs == Signs::kAlike && wanted[k] == 0 && found[k] == 0) continue;
      if (!same_bits(wanted[k], found[k])) return ValueDifference{original.id[i], kFields[k], wanted[k], found[k]};
    }
  }
  if (others == Others::kNone && image.size() > original.size()) return ValueDifference{0, "number of bodies", 0, 0};
  return std::nullopt;
}

std::string first_phase(sim::Method method, const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  const sim::PhaseTable table = sim::phase_table(method);
  const auto [at, other] = std::ranges::mismatch(a, b);
  if (at == a.end() || other == b.end()) return {};
  return table.phases[static_cast<std::size_t>(at - a.begin()) % table.phases.size()].name;
}

Judgement compare_steps(sim::Method method, std::uint64_t step, const StepTaken& wanted, const StepTaken& found) {
  const auto difference = first_difference(wanted.state.bodies, found.state.bodies, {}, {});
  Judgement out;
  if (difference) {
    out = parted(step, *difference);
  } else if (found.words != wanted.words) {
    out = broken(step, 0, "the hash of a phase differs, though no body does");
  } else if (!(found.counters == wanted.counters)) {
    out = broken(step, 0, "counts or energies of the step differ, though no body does");
  } else if (continuation_hash(found.state) != continuation_hash(wanted.state)) {
    out = broken(step, 0, "hidden state differs, though no body does");
  }
  if (out.outcome == Outcome::kBroken) out.phase = first_phase(method, wanted.words, found.words);
  return out;
}

Judgement parted(std::uint64_t step, const ValueDifference& difference) {
  return broken(step, difference.body,
                difference.field + " is " + exact(difference.b) + " instead of " + exact(difference.a),
                std::abs(difference.a - difference.b));
}

Judgement judge_image(const Trace& trace, const Transform& transform) {
  const sim::IdMap ids = ids_under(trace.scene, transform);
  // Orientations of the first state are normalised twice alike in both.
  const sim::SceneDef image = image_of(trace.scene, transform, ids);
  Result<replay::Session> session = replay::Session::start(image);
  if (!session.ok()) return not_applicable("the image is no scene: " + session.error().message);
  for (std::size_t k = 0; k <= trace.steps.size(); ++k) {
    if (k > 0) {
      const auto taken = session->step();
      if (!taken.ok()) return failed(k, taken.error().message);
    }
    const auto difference = first_difference(trace.states[k].bodies, session->world().bodies(), transform, ids);
    if (difference) return parted(k, *difference);
  }
  return held();
}

Judgement judge_again(const Trace& trace, sim::LaneWidth lanes) {
  Result<replay::Session> session = replay::Session::start(trace.scene);
  if (!session.ok()) return failed(0, session.error().message);
  session->use(lanes);
  return compare_session(trace, *session);
}

namespace {

// Step k of the trace, taken from a snapshot of the state before.
Judgement judge_step(const Trace& trace, std::size_t k, Workers* workers) {
  Result<replay::Session> session = replay::Session::resume(trace.before(k));
  if (!session.ok()) return failed(k, "its state is refused: " + session.error().message);
  session->use(workers);
  sim::PhaseHashes hashes;
  const auto taken = session->step(trace.steps[k].inputs, &hashes);
  if (!taken.ok()) return failed(k + 1, taken.error().message);
  return compare_step(trace, k, session->world().state(), hashes.words(), taken->counters);
}

}  // namespace

Judgement judge_resumed(const Trace& trace) {
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    Judgement one = judge_step(trace, k, nullptr);
    if (one.outcome != Outcome::kHeld) return one;
  }
  return held();
}

Judgement judge_threads(const Trace& trace) {
  if (judge_resumed(trace).outcome == Outcome::kBroken) return not_applicable("a step from a snapshot differs already");
  WorkerThreads workers(kThreads, Split::kEverything);
  for (std::size_t part = 1; part <= kThreadedSteps; ++part) {
    const std::size_t k = trace.steps.size() * part / kThreadedSteps;
    if (k == 0) continue;
    Judgement one = judge_step(trace, k - 1, &workers);
    if (one.outcome != Outcome::kHeld) return one;
  }
  return held();
}

Judgement judge_inserted(const Trace& trace) {
  if (trace.scene.boxes.size() < 2) return not_applicable("one body has one order");
  for (const sim::BoxDef& box : trace.scene.boxes) {
    if (box.frozen) return not_applicable("a body that begins frozen is told what it rests on at the start alone");
  }
  sim::SceneDef empty = trace.scene;
  empty.boxes.clear();
  Result<replay::Session> session = replay::Session::start(empty);
  if (!session.ok()) return not_applicable("no world without bodies: " + session.error().message);
  std::vector<sim::Command> inputs;
  for (std::size_t k = trace.scene.boxes.size(); k > 0; --k) inputs.emplace_back(sim::Throw{trace.scene.boxes[k - 1]});
  if (trace.steps.empty()) return held();
  // The scene's inputs of step 1 come before live ones, and may name a body.
  for (const sim::TimedCommand& input : trace.scene.inputs) {
    if (input.step == 1) return not_applicable("an input before step 1 comes before the bodies");
  }
  for (std::size_t k = 0; k < trace.steps.size(); ++k) {
    const auto taken = k == 0 ? session->step(inputs) : session->step();
    if (!taken.ok()) return failed(k + 1, taken.error().message);
    const auto difference = first_difference(trace.after(k).bodies, session->world().bodies(), {}, {});
    if (difference) return parted(k + 1, *difference);
  }
  return held();
}

namespace {

bool comes_near(const sim::Bodies& bodies, double where) {
  for (BodyIndex i = 0; i < bodies.size(); ++i) {
    if (bodies.position[i].x() > where - kOthersNear) return true;
  }
  return false;
}

}  // namespace

Judgement judge_elsewhere(const Trace& trace) {
  if (trace.scene.world.method == sim::Method::kThesis) {
    return not_applicable("method thesis halves a step for all bodies at once");
  }
  const std::optional<Neighboured> both = with_neighbours(trace.scene);
  if (!both) return not_applicable("no room for others");
  Result<replay::Session> session = replay::Session::start(both->scene);
  if (!session.ok()) return not_applicable("no scene with others: " + session.error().message);
  for (std::size_t k = 0; k <= trace.steps.size(); ++k) {
    if (k > 0 && !session->step().ok()) return not_applicable("the others end the session");
    const sim::Bodies& bodies = trace.states[k].bodies;
    if (comes_near(bodies, both->where)) return not_applicable("a body comes near the others");
    const auto difference =
        first_difference(bodies, session->world().bodies(), {}, {}, Signs::kApart, Others::kAllowed);
    if (difference) return parted(k, *difference);
  }
  return held();
}

}  // namespace tumble::hunt
