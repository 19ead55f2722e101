#include "replay/diff/locate_divergence.h"

#include <optional>
#include <utility>

#include "src/base/check.h"

namespace tumble::replay {
namespace {

/// The states after a step, stored or taken again; none where neither can be had.
std::optional<BodyStates> states_after(LogReader& log, std::uint64_t k, const std::optional<RetakenStep>& taken) {
  const Result<const StepRecord*> stored = log.read_step(k);
  if (stored.ok() && (*stored)->has_states) return (*stored)->states;
  if (taken && taken->same) return taken->record.states;
  return std::nullopt;
}

/// None of another engine's log: no build of ours takes that engine's steps, which is no news.
std::optional<RetakenStep> retake(LogReader& log, std::uint64_t k, std::string& why_not) {
  if (log.header().engine) return std::nullopt;
  Result<RetakenStep> taken = retake_step(log, k);
  if (taken.ok()) return *std::move(taken);
  if (why_not.empty()) why_not = taken.error().message;
  return std::nullopt;
}

/// Body and field instead of a hash, now that there are states.
void name_body(Divergence& first, const BodyStates& a, const BodyStates& b) {
  const bool only_hash = first.field == "phase_hash" || first.field == "state_hash";
  if (!only_hash) return;
  std::optional<Divergence> body = first_difference(a, b);
  if (!body) return;
  body->step = first.step;
  body->substep = first.substep;
  body->phase = first.phase;
  first = *std::move(body);
}

/// The contacts of a body, none if there is no body.
std::vector<StepContact> contacts_of(const std::optional<sim::BodyId>& body, const std::vector<StepContact>& contacts) {
  std::vector<StepContact> of_body;
  for (const StepContact& contact : contacts) {
    if (body && contact.has(*body)) of_body.push_back(contact);
  }
  return of_body;
}

}  // namespace

// A log says that two sessions differ after step k. It does not say which of them the program at hand agrees with, nor
// which contact the difference came through. Both follow from step k alone, taken again from each log's own state k −
// 1: up to there the two are equal, so any difference of the results lies in that step.
DivergenceLocation locate_divergence(LogReader& a, LogReader& b, Divergence& first) {
  DivergenceLocation location;
  if (first.step <= a.first_state() || first.step <= b.first_state()) return location;
  const std::uint64_t k = first.step;
  const std::optional<RetakenStep> in_a = retake(a, k, location.not_taken);
  const std::optional<RetakenStep> in_b = retake(b, k, location.not_taken);
  location.taken = in_a || in_b;
  location.as_a = in_a && in_a->same;
  location.as_b = in_b && in_b->same;
  const std::optional<BodyStates> after_a = states_after(a, k, in_a);
  const std::optional<BodyStates> after_b = states_after(b, k, in_b);
  if (after_a && after_b) {
    name_body(first, *after_a, *after_b);
    location.bodies = differing_bodies(*after_a, *after_b);
  }
  const std::optional<RetakenStep>& witness = location.as_b && !location.as_a ? in_b : in_a;
  if (!witness || first.phase == "inputs") return location;
  if (location.as_a || location.as_b) first.pair = pair_of(location.bodies, witness->contacts);
  location.contacts = contacts_of(first.body, witness->contacts);
  return location;
}

DivergenceLocation locate_in_replay(LogReader& log, Divergence& first) {
  SIM_CHECK(first.step > log.first_state(), first.step, log.first_state());
  DivergenceLocation location;
  const std::optional<RetakenStep> taken = retake(log, first.step, location.not_taken);
  const Result<const StepRecord*> logged = log.read_step(first.step);
  if (!taken || !logged.ok() || !(*logged)->has_states) return location;
  location.taken = true;
  location.as_a = taken->same;
  location.bodies = differing_bodies((*logged)->states, taken->record.states);
  if (first.phase == "inputs") return location;
  first.pair = pair_of(location.bodies, taken->contacts);
  location.contacts = contacts_of(first.body, taken->contacts);
  return location;
}

Result<LocatedDivergence> diff_and_locate(LogReader& a, LogReader& b, const Progress& progress) {
  const std::uint64_t before = a.chunks_opened() + b.chunks_opened();
  Result<DiffReport> report = diff_logs(a, b, {}, progress);
  if (!report.ok()) return report.error();
  LocatedDivergence located{*std::move(report), {}, 0};
  if (located.report.first) located.location = locate_divergence(a, b, *located.report.first);
  located.chunks_opened = a.chunks_opened() + b.chunks_opened() - before;
  return located;
}

}  // namespace tumble::replay
