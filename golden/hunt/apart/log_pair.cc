#include "golden/hunt/apart/log_pair.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "replay/log/byte_memory.h"
#include "src/base/text.h"
#include "tumble/replay/compare.h"
#include "tumble/replay/recorder.h"

namespace tumble::hunt {
namespace {

constexpr const char* kStartPhase = "start";
constexpr double kSamePlace = 1e-6;  // m: state 0 is rounded to a grid, which a build may choose otherwise

Judgement other_start(sim::BodyId body, const std::string& what) {
  Judgement out = broken(0, body, "the start differs: " + what);
  out.phase = kStartPhase;
  return out;
}

// The first body by id that one scene lacks or has otherwise; 0: none.
sim::BodyId first_other_body(const sim::SceneDef& a, const sim::SceneDef& b) {
  for (std::size_t k = 0; k < std::max(a.boxes.size(), b.boxes.size()); ++k) {
    if (k >= a.boxes.size()) return b.boxes[k].id;
    if (k >= b.boxes.size()) return a.boxes[k].id;
    if (!(a.boxes[k] == b.boxes[k])) return std::min(a.boxes[k].id, b.boxes[k].id);
  }
  return 0;
}

std::string here_and_there(const replay::HeaderDifference& one) { return replay::describe(one) + " (here → there)"; }

// Masses, sizes and places of state 0, which the headers do not vouch for.
Judgement compare_first_states(const sim::Bodies& mine, const sim::Bodies& other) {
  for (sim::BodyIndex i = 0; i < std::max(mine.size(), other.size()); ++i) {
    if (i >= other.size() || (i < mine.size() && mine.id[i] < other.id[i]))
      return other_start(mine.id[i], "the other build lacks the body");
    if (i >= mine.size() || other.id[i] < mine.id[i])
      return other_start(other.id[i], "the other build alone has the body");
    const auto differs = [&](const char* what, double here, double there) {
      return other_start(mine.id[i], std::string(what) + " is " + exact(here) + " here and " + exact(there) + " there");
    };
    if (mine.is_static[i] != other.is_static[i]) return other_start(mine.id[i], "it is static in one session alone");
    if (mine.mass[i] != other.mass[i]) return differs("mass, kg,", mine.mass[i], other.mass[i]);
    for (int axis = 0; axis < 3; ++axis) {
      const double size = 2 * mine.half_extent[i][axis], there = 2 * other.half_extent[i][axis];
      if (size != there) return differs("size, m,", size, there);
      const double place = mine.position[i][axis], place_there = other.position[i][axis];
      if (!(std::fabs(place - place_there) <= kSamePlace)) return differs("position, m,", place, place_there);
    }
  }
  return held();
}

// The distance of two numbers; 0 where there is none.
double distance_of(const replay::Divergence& one) {
  const auto* a = std::get_if<double>(&one.expected);
  const auto* b = std::get_if<double>(&one.actual);
  const double by = a != nullptr && b != nullptr ? std::fabs(*a - *b) : 0;
  return std::isfinite(by) ? by : 0;
}

Judgement parted_logs(const replay::Divergence& one, const replay::DiffReport& report) {
  std::string what =
      one.field + " is " + replay::to_string(one.actual) + " there instead of " + replay::to_string(one.expected);
  if (const replay::HeaderDifference* cause = replay::first_cause(report.headers); cause != nullptr)
    what += "; the headers differ too: " + here_and_there(*cause);
  if (one.step == 0) what.insert(0, "the start differs: ");
  Judgement out = broken(one.step, one.body.value_or(0), std::move(what), distance_of(one));
  out.phase = one.step == 0 ? kStartPhase : one.phase;
  return out;
}

// This build's log of the session, in memory.
Result<replay::LogReader> log_of(const Trace& trace) {
  const auto file = std::make_shared<std::vector<std::byte>>();
  auto recorder =
      replay::Recorder::start(std::make_unique<replay::MemoryByteSink>(file, "this build"), trace.scene, {});
  if (!recorder.ok()) return recorder.error();
  if (const Status ok = (*recorder)->run(); !ok.ok()) return ok.error();
  if (const auto summary = (*recorder)->finish(); !summary.ok()) return summary.error();
  return replay::LogReader::open(std::make_unique<replay::MemoryByteSource>(file, "this build"));
}

}  // namespace

Judgement log_unread(std::uint64_t step, const Error& error) {
  return broken(step, 0, "the other build's log cannot be read: " + error.message);
}

Judgement compare_starts(const Trace& mine, replay::LogReader& other, Starts how) {
  const sim::SceneDef& here = mine.scene;
  sim::SceneDef there = other.header().scene;
  // Settings of the world and inputs are no bodies.
  there.world = here.world;
  there.inputs = here.inputs;
  if (how == Starts::kPlaced) {
    for (sim::BoxDef& box : there.boxes) {
      const auto same = std::ranges::find(here.boxes, box.id, &sim::BoxDef::id);
      if (same != here.boxes.end()) box.material = same->material;
    }
  }
  const std::vector<replay::HeaderDifference> differences = replay::scene_differences(here, there);
  if (const replay::HeaderDifference* cause = replay::first_cause(differences); cause != nullptr)
    return other_start(first_other_body(here, there), here_and_there(*cause));
  const Result<const replay::Keyframe*> first = other.keyframe_at_or_before(0);
  if (!first.ok()) return log_unread(0, first.error());
  return compare_first_states(mine.states.front().bodies, (*first)->state.bodies);
}

Judgement compare_lengths(const Trace& mine, const replay::LogReader& other) {
  const std::uint64_t last = mine.steps.size(), last_there = other.last_step();
  if (last == last_there) return held();
  return broken(std::min(last, last_there), 0,
                "the other build's session has another number of steps: it ends with step " +
                    std::to_string(last_there) + ", this one with " + std::to_string(last));
}

Judgement compare_bits(const Trace& mine, replay::LogReader& other) {
  Judgement start = compare_starts(mine, other, Starts::kEveryBit);
  if (start.outcome != Outcome::kHeld) return start;
  Result<replay::LogReader> log = log_of(mine);
  if (!log.ok()) return not_applicable("this build's session cannot be recorded: " + log.error().message);
  const Result<replay::DiffReport> report = replay::diff_logs(*log, other);
  if (!report.ok()) return log_unread(0, report.error());
  if (report->first) return parted_logs(*report->first, *report);
  if (report->built) return parted_logs(*report->built, *report);
  if (Judgement lengths = compare_lengths(mine, other); lengths.outcome != Outcome::kHeld) return lengths;
  const auto differences = replay::scene_differences(log->header().scene, other.header().scene);
  if (const replay::HeaderDifference* cause = replay::first_cause(differences); cause != nullptr)
    return broken(0, 0, "the header differs: " + here_and_there(*cause));
  return held();
}

}  // namespace tumble::hunt
