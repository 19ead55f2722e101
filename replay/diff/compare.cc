#include "tumble/replay/compare.h"

#include <algorithm>
#include <utility>

#include "replay/diff/channel_difference.h"
#include "replay/diff/world_difference.h"
#include "replay/format/chain.h"
#include "replay/log/checked_log.h"
#include "replay/log/hashes_only.h"
#include "replay/log/log_facts.h"
#include "src/base/text.h"
#include "tumble/replay/body_states.h"

namespace tumble::replay {
namespace {

/// One comparison of two logs, A and B, of one of three kinds. Exact: hashes decide, states name body and field. With
/// tolerances: states decide, as soon as hashes differ. Of two engines: dt and states decide, because engines differ in
/// phases, counters and inputs.
class Diff {
 public:
  Diff(LogReader& a, LogReader& b, CheckedLogs& checked, const Tolerances& tolerances = {},
       Reading reading = Reading::kAll, std::uint64_t until = kNoLimit)
      : a_(a), b_(b), checked_(checked), tolerances_(tolerances), reading_(reading), until_(until) {
    values_in_one_ = one_holds_hashes_only(a.header(), b.header());
    const bool hashes_in_both = holds_hashes_only(a.header()) && !values_in_one_;
    states_only_ = are_two_engines(a.header(), b.header()) && !hashes_in_both;
    if (!states_only_ && !values_in_one_) phases_ = match_phases(a.header(), b.header());
    imported_ = a.header().engine || b.header().engine;
    channels_ = match_channels(a.header(), b.header(), tolerances, states_only_);
    derived_ = derived_values(a.header(), b.header());
    if (!states_only_ || values_in_one_) report_.only_in = only_in_one(a.header(), b.header());
    if (hashes_in_both && a.first_state() != b.first_state()) leave_out_start_hashes();
  }

  Result<DiffReport> run(const Progress& progress) {
    report_.notes = notes_on_wholeness(a_, b_);
    if (Status ok = check_both(progress); !ok.ok()) return ok.error();
    report_.last_a = std::min(a_.last_step(), until_);
    report_.last_b = std::min(b_.last_step(), until_);
    const std::uint64_t from = report_.from = std::max(a_.first_state(), b_.first_state());
    const std::uint64_t last = std::min(report_.last_a, report_.last_b);
    if (from > last) return no_common_step();
    for (std::uint64_t k = from + 1; k <= last; ++k) report_.steps += a_.holds(k) && b_.holds(k) ? 1U : 0U;
    report_.headers = header_differences(a_.header(), b_.header(), tolerances_);
    if (!tells_dt(a_) || !tells_dt(b_))
      std::erase_if(report_.headers, [](const auto& d) { return d.key == "world.dt"; });
    if (std::ranges::any_of(report_.headers, &HeaderDifference::acts)) add_notes_on_cuts(a_, b_, report_.notes);
    if (Status ok = compare_worlds(from, last); !ok.ok()) return ok.error();
    if (Status ok = compare_start(from); !ok.ok()) return ok.error();
    if (report_.first) return finished();
    const bool one_chain = phases_.equal && channels_.equal && a_.header().hashes == b_.header().hashes;
    const Result<std::uint64_t> same =  // chains cover phase words and channels
        one_chain ? last_of_one_chain(a_, b_, from, last) : Result<std::uint64_t>(from);
    if (!same.ok()) return same.error();
    for (std::uint64_t k = *same + 1; k <= last && !report_.first; ++k) {
      if (a_.lost_at(k) != nullptr || b_.lost_at(k) != nullptr) continue;
      if (Status ok = compare_step(k); !ok.ok()) return ok.error();
      if (progress && !progress(k - from, last - from)) return cannot_finish("interrupted");
    }
    // Hidden state shows in visible columns steps later: the keyframe that differs first is nearer to the cause.
    if (keyframe_differs_ && (!report_.first || keyframe_differs_->step < report_.first->step)) {
      report_.first = std::move(keyframe_differs_);
    }
    return finished();
  }

 private:
  [[nodiscard]] Error no_common_step() const {
    const auto range = [](const LogReader& log) {
      return log.name() + " holds steps " + std::to_string(log.first_state()) + " to " +
             std::to_string(log.last_step());
    };
    return bad_input("found no step in common: " + range(a_) + ", " + range(b_));
  }

  /// Reads every byte of both logs: an answer speaks of nothing that was not read.
  Status check_both(const Progress& progress) {
    if (reading_ == Reading::kHashes) return {};
    const Result<const VerifyReport*> in_a = checked_.check(a_, progress);
    if (!in_a.ok()) return in_a.error();
    const Result<const VerifyReport*> in_b = checked_.check(b_, progress);
    if (!in_b.ok()) return in_b.error();
    const VerifyReport &of_a = **in_a, &of_b = **in_b;
    for (const auto& [log, checked] : {std::pair(&a_, &of_a), std::pair(&b_, &of_b)}) {
      if (checked->lost && checked->lost->step <= until_)
        report_.notes.push_back(log->name() + ": " + to_string(*checked->lost, log->header().axes()));
    }
    no_contacts_ = !of_a.has_contacts_by(until_) || !of_b.has_contacts_by(until_);
    leave_out_contacts(of_a.has_contacts_by(until_), of_b.has_contacts_by(until_));
    keyframes_a_ = of_a.keyframes;
    keyframes_b_ = of_b.keyframes;
    return {};
  }

  /// Of two logs of hashes, one of which begins later: their only channels are hashes of two starts.
  void leave_out_start_hashes() {
    channels_ = ChannelMatch();
    channels_.equal = false;
    report_.only_in = {};
  }

  bool leave_out_contacts(bool in_a, bool in_b) {
    const bool compared = tolerances_.exact() && !values_in_one_;
    return compared && leave_out_contacts_of_one(in_a, in_b, channels_, report_.only_in);
  }

  /// Of logs whose payloads were not read: whether their first difference is in contacts that one log alone tells.
  bool contacts_are_of_one() {
    if (reading_ != Reading::kHashes || !report_.first || report_.first->phase != "contacts") return false;
    return leave_out_contacts(tells_contacts(a_, until_), tells_contacts(b_, until_));
  }

  /// Compares the complete states that both logs hold, where scene and method are equal: then every part of them must
  /// be. A difference of the world that was built from the scene is the cause of all that follows.
  Status compare_worlds(std::uint64_t from, std::uint64_t last) {
    one_scene_ = std::ranges::none_of(report_.headers, &HeaderDifference::acts);
    if (imported_ || !one_scene_) return {};
    for (auto one = keyframes_a_.begin(), other = keyframes_b_.begin();
         one != keyframes_a_.end() && other != keyframes_b_.end();) {
      if (one->step != other->step) {
        ++(one->step < other->step ? one : other);
        continue;
      }
      const KeyframeHash& in_a = *one++;
      const KeyframeHash& in_b = *other++;
      if (in_a.step < from || in_a.step > last) continue;
      ++worlds_;
      if (keyframe_differs_ || in_a.continuation_hash == in_b.continuation_hash) continue;
      if (Status ok = name_property(in_a, in_b, from); !ok.ok()) return ok;
    }
    return {};
  }

  Status name_property(const KeyframeHash& in_a, const KeyframeHash& in_b, std::uint64_t from) {
    if (in_a.step != from && !tolerances_.exact()) return {};
    const Result<const Keyframe*> a = a_.keyframe_at_or_before(in_a.step);
    if (!a.ok()) return a.error();
    const Result<const Keyframe*> b = b_.keyframe_at_or_before(in_b.step);
    if (!b.ok()) return b.error();
    const sim::WorldState &expected = (*a)->state, &actual = (*b)->state;
    if (in_a.step == from) report_.built = world_difference(expected, actual, {.visible = false, .hidden = false});
    if (!tolerances_.exact()) return {};
    keyframe_differs_ = keyframe_difference(expected, in_a.continuation_hash, actual, in_b.continuation_hash);
    if (in_a.step > from) keyframe_differs_->phase = "step";
    return {};
  }

  /// Adds to the report what it speaks of.
  Result<DiffReport> finished() {
    if (!report_.first && !states_only_ && !values_in_one_ && reading_ == Reading::kAll) {
      add_later_shapes(a_, b_, until_, report_.only_in.a);
      add_later_shapes(b_, a_, until_, report_.only_in.b);
    }
    const DiffFacts facts = {report_.from,
                             std::min(report_.last_a, report_.last_b),
                             reading_ == Reading::kHashes,
                             states_only_,
                             phases_,
                             imported_,
                             no_contacts_,
                             one_scene_,
                             worlds_,
                             report_.zeros,
                             report_.states_read,
                             names_of(channels_),
                             left_out(channels_, derived_, imported_, tolerances_)};
    report_.scope = scope_of(a_, b_, tolerances_, facts);
    if (until_ < std::max(a_.last_step(), b_.last_step())) {
      report_.until = until_;
      report_.scope.not_compared.push_back(report_.behind());
    }
    return std::move(report_);
  }

  /// Compares the first states of both, without the inputs and phases that led there.
  Status compare_start(std::uint64_t from) {
    if (values_in_one_) return {};
    StepRecord start_a, start_b;
    if (Status ok = read_start(a_, from, start_a); !ok.ok()) return ok;
    if (Status ok = read_start(b_, from, start_b); !ok.ok()) return ok;
    if (Status ok = can_tolerate(start_a, start_b); !ok.ok()) return ok;
    judge(start_a, start_b);
    if (!report_.first && !channels_.other_kinds.empty()) report_.first = channels_.other_kinds.front();
    if (!report_.first) return {};
    report_.first->step = from;
    report_.first->phase = "start";
    return {};
  }

  /// Compares step k by one hash: chain_next() covers every field of a record but its states, which a hash stands for.
  Status compare_step(std::uint64_t k) {
    Result<const StepRecord*> a = a_.read_hashes(k);
    if (!a.ok()) return a.error();
    Result<const StepRecord*> b = b_.read_hashes(k);
    if (!b.ok()) return b.error();
    if (values_in_one_ && (*a)->dt == (*b)->dt) return {};
    const bool by_states = states_only_ && channels_.compared.empty();
    if (by_states && (*a)->dt == (*b)->dt && (*a)->state_hash == (*b)->state_hash) return {};
    StepRecord expected = **a, actual = **b;
    leave_out_words(expected, actual);
    if (same_step(channels_, expected, actual)) return {};
    return compare_states(k, **a, **b);
  }

  /// Tolerances need states: hashes only tell that two states differ, not by how much.
  [[nodiscard]] Status can_tolerate(const StepRecord& a, const StepRecord& b) const {
    if (tolerances_.exact() || (a.has_states && b.has_states) || a.state_hash == b.state_hash) return {};
    return bad_input("step " + std::to_string(a.step) +
                     ": its hashes differ and one log has no states of it, so tolerances cannot be judged; record "
                     "both with --states all");
  }

  /// Compares a step whose hashes differ, with its states where both logs hold them.
  Status compare_states(std::uint64_t k, const StepRecord& hashes_a, const StepRecord& hashes_b) {
    if (Status ok = can_tolerate(hashes_a, hashes_b); !ok.ok()) return ok;
    StepRecord expected = hashes_a;
    StepRecord actual = hashes_b;
    if (hashes_a.has_states && hashes_b.has_states) {
      Result<const StepRecord*> a = a_.read_step(k);
      if (!a.ok()) return a.error();
      Result<const StepRecord*> b = b_.read_step(k);
      if (!b.ok()) return b.error();
      expected = **a;
      actual = **b;
      ++report_.states_read;
    }
    judge(expected, actual);
    return {};
  }

  /// Finds the first difference. Fields that this kind of comparison leaves out are first made equal in `actual`.
  void judge(StepRecord& expected, StepRecord& actual) {
    if (values_in_one_) actual.dt = std::exchange(actual, expected).dt;  // no more than the length is in both
    leave_out_words(expected, actual);
    find_first(expected, actual);
    if (contacts_are_of_one()) find_first(expected, actual);
    if (report_.first && in_binary32(a_.header(), b_.header())) count_in_binary32(*report_.first);
  }

  void find_first(const StepRecord& expected, StepRecord& actual) {
    if (imported_) report_.zeros += forgive_zeros(expected, actual);
    forgive_derived(derived_, expected, actual);
    if (!tolerances_.exact()) {
      forgive_states(expected.states, actual.states, tolerances_);
      forgive_inputs(expected, actual, tolerances_);
      actual.counters = expected.counters;  // they differ as soon as one bit does
    }
    if (states_only_) {
      actual.counters = expected.counters;
      actual.inputs = expected.inputs;
    }
    const bool by_states = (imported_ || !tolerances_.exact()) && expected.has_states && actual.has_states;
    if (by_states && same_bits(expected.states, actual.states)) actual.state_hash = expected.state_hash;
    const std::vector<std::string> phases = tolerances_.exact() ? phases_.names : std::vector<std::string>();
    report_.first = first_difference(expected, actual, phases);
    add_extra_difference(channels_, expected, actual, tolerances_, report_.first);
  }

  void leave_out_words(StepRecord& expected, StepRecord& actual) const {
    if (states_only_) actual.phase_words = expected.phase_words;
    match_phase_words(phases_, a_.header(), b_.header(), expected, actual);
  }

  LogReader &a_, &b_;
  CheckedLogs& checked_;
  Tolerances tolerances_;
  Reading reading_;
  std::uint64_t until_;
  PhaseMatch phases_;
  bool states_only_ = false;                     // of two engines, whose phases and counters cannot be compared
  bool imported_ = false, no_contacts_ = false;  // a log, or both, by another engine; neither has a contact
  bool values_in_one_ = false;                   // the other holds hashes only
  std::vector<KeyframeHash> keyframes_a_, keyframes_b_;
  bool one_scene_ = false;                      // no value that a step depends on differs between the headers
  std::uint64_t worlds_ = 0;                    // complete states compared
  std::optional<Divergence> keyframe_differs_;  // the first of them that differs
  ChannelMatch channels_;
  DerivedValues derived_;
  DiffReport report_;
};

}  // namespace

Result<DiffReport> diff_logs(LogReader& a, LogReader& b, const Tolerances& tolerances, const Progress& progress,
                             Reading reading, std::uint64_t until) {
  for (const LogReader* log : {&a, &b}) {
    if (tolerances.exact() || !holds_hashes_only(log->header())) continue;
    return bad_input(log->name() + ": holds hashes only, wanted values: tolerances cannot be judged");
  }
  CheckedLogs checked;
  return Diff(a, b, checked, tolerances, reading, until).run(progress);
}

Result<DiffReport> diff_logs(CheckedLogs& checked, LogReader& a, LogReader& b, const Progress& progress) {
  return Diff(a, b, checked).run(progress);
}

}  // namespace tumble::replay
