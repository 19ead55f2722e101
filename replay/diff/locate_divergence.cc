#include "replay/diff/locate_divergence.h"

#include <utility>

namespace tumble::replay {
namespace {

/// The states after a step, stored or taken again; none where neither can be had.
std::optional<BodyStates> states_after(LogReader& log, std::uint64_t k, const std::optional<RetakenStep>& taken) {
  const Result<const StepRecord*> stored = log.read_step(k);
  if (stored.ok() && (*stored)->has_states) return (*stored)->states;
  if (taken && taken->same) return taken->record.states;
  return std::nullopt;
}

std::optional<RetakenStep> retake(LogReader& log, std::uint64_t k, std::string& why_not) {
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

}  // namespace

Narrowing narrow(LogReader& a, LogReader& b, DiffReport report) {
  Narrowing narrowing;
  narrowing.report = std::move(report);
  std::optional<Divergence>& first = narrowing.report.first;
  if (!first || first->step <= a.first_state() || first->step <= b.first_state()) return narrowing;
  const std::uint64_t k = first->step;
  const std::optional<RetakenStep> in_a = retake(a, k, narrowing.not_taken);
  const std::optional<RetakenStep> in_b = retake(b, k, narrowing.not_taken);
  narrowing.as_a = in_a && in_a->same;
  narrowing.as_b = in_b && in_b->same;
  const std::optional<BodyStates> after_a = states_after(a, k, in_a);
  const std::optional<BodyStates> after_b = states_after(b, k, in_b);
  if (after_a && after_b) {
    name_body(*first, *after_a, *after_b);
    narrowing.bodies = differing_bodies(*after_a, *after_b);
  }
  const std::optional<RetakenStep>& witness = narrowing.as_b && !narrowing.as_a ? in_b : in_a;
  if (!witness || first->phase == "inputs") return narrowing;
  if (narrowing.as_a || narrowing.as_b) first->pair = pair_of(narrowing.bodies, witness->contacts);
  for (const StepContact& contact : witness->contacts) {
    if (first->body && contact.has(*first->body)) narrowing.contacts.push_back(contact);
  }
  return narrowing;
}

Result<Narrowing> narrow(LogReader& a, LogReader& b, const Progress& progress) {
  const std::uint64_t before = a.chunks_opened() + b.chunks_opened();
  Result<DiffReport> report = diff_logs(a, b, {}, progress);
  if (!report.ok()) return report.error();
  Narrowing narrowing = narrow(a, b, *std::move(report));
  narrowing.chunks_opened = a.chunks_opened() + b.chunks_opened() - before;
  return narrowing;
}

}  // namespace tumble::replay
