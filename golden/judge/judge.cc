#include "tumble/golden/judge.h"

#include <algorithm>

#include "golden/judge/judge_metrics.h"
#include "golden/suite/file_changes.h"
#include "golden/suite/metric_values.h"
#include "replay/format/not_finite.h"
#include "replay/import/table_notes.h"
#include "replay/log/hashes_only.h"
#include "replay/log/told_values.h"
#include "replay/session/state_source.h"
#include "src/base/text.h"

namespace tumble::golden {
namespace {

constexpr const char* kExactValues = "exact values: record a full log with the command below and compare it by diff";

constexpr std::size_t kLinesNamed = 4;  // of a scene, in a message; JSON and page have all

std::string number(std::uint64_t value) { return std::to_string(value); }

/// One pass over a log: compares, measures and collects a new golden.
class Pass {
 public:
  Pass(replay::LogReader& log, const Reference& reference)
      : log_(log),
        reference_(reference),
        told_(log.header()),
        metrics_(log.header(), reference.rules),
        builder_(log.header(), log.step_count(), reference.scene) {
    if (reference.expected != nullptr) comparer_.emplace(*reference.expected, log.header());
  }

  Judged run() {
    Judged judged;
    CaseResult& result = judged.result;
    result.steps = log_.step_count();
    if (replay::holds_hashes_only(log_.header())) {
      result.problems.emplace_back("its session holds hashes only, wanted values: there is no body to judge");
      return judged;
    }
    if (const Status status = read_all(); !status.ok()) {
      result.problems.push_back(status.error().message);
      return judged;
    }
    if (!log_.condition().whole()) result.problems.push_back("its log is " + log_.condition().summary(result.steps));
    if (lost_) result.problems.push_back("not finite: " + to_string(*lost_, log_.header().axes()));
    if (const std::string lost = contacts_.not_finite(); !lost.empty())
      result.problems.push_back("not finite: " + lost);
    if (const std::string told = told_.impossible(); !told.empty()) result.problems.push_back(told);
    result.bodies = bodies_;
    result.final_hash = to_string(final_hash_);
    result.continuation = to_string(reference_.continuation);
    if (reference_.expected != nullptr) result.blessed_by = reference_.expected->provenance;
    judged.actual = builder_.finish(reference_.continuation);
    judge_exact(result);
    judge_behaviour(judged);
    if (std::string odd = contacts_.no_direction(); !odd.empty()) result.notes.push_back(std::move(odd));
    if (std::string told = told_.note(); !told.empty()) result.notes.push_back(std::move(told));
    return judged;
  }

 private:
  Status read_all() {
    replay::StateSource source(log_);
    for (std::uint64_t k = 0; k <= log_.step_count(); ++k) {
      const Result<const replay::StepRecord*> record = source.read(k);
      if (!record.ok()) return record.error();
      const replay::StepRecord& step = **record;
      if (replay::state_hash(step.states) != step.state_hash) {
        return damaged("step " + number(k) + ": the states do not match their hashes");
      }
      if (comparer_) comparer_->add(step);
      contacts_.add(k, step.extras.contacts);
      if (!lost_) lost_ = replay::first_not_finite(step.states, step.step);
      told_.add(step);
      metrics_.add(step);
      builder_.add(step);
      final_hash_ = step.state_hash;
      for (const sim::Command& input : step.inputs) bodies_ += std::holds_alternative<sim::Throw>(input) ? 1U : 0U;
      if (k == 0) {
        bodies_ = step.states.size();
        start_ = step.states.id;
      }
      if (k == log_.step_count()) last_ = step.states;
    }
    return {};
  }

  void judge_exact(CaseResult& result) {
    Verdict& exact = result.verdict(VerdictKind::kExact);
    if (result.steps == 0) {
      result.problems.emplace_back("its session has no step: nothing to compare");
      return;
    }
    if (reference_.expected == nullptr) return;  // the caller reports why there is none
    const Expected& expected = *reference_.expected;
    if (expected.steps() == 0) {
      result.problems.emplace_back("expected.tumble is empty: it holds no step to compare");
      return;
    }
    if (expected.scene != reference_.scene) {
      judge_scene(result, expected);
    } else {
      judge_extent(result, expected);
    }
    const bool same_words = expected.phase_hash_version == log_.header().phase_hash_version;
    if (!same_words) {
      result.problems.push_back("stale: blessed with phase hashes of version " + number(expected.phase_hash_version) +
                                ", run with version " + number(log_.header().phase_hash_version) +
                                ", which cover different fields: states and metrics were compared, phase "
                                "hashes were not; bless the case if it has no other fault");
    }
    result.notes = comparer_->notes();
    result.difference = comparer_->finish(reference_.continuation);
    if (!result.difference) {
      std::string message = "same bits in all " + number(expected.state_hashes.size()) + " states";
      for (const std::string& part : comparer_->extras()) message += ", " + part;
      exact = {Outcome::kPass, message + (same_words ? "" : ", phase hashes of another version")};
      return;
    }
    exact = {Outcome::kFail, "first difference: " + describe(*result.difference)};
    result.difference->details.emplace_back(kExactValues);
  }

  /// A session of another length, of other bodies or shapes, or without a channel is not the one that was blessed, and
  /// no bound excuses that: an engine that ends early has less time to go wrong.
  void judge_extent(CaseResult& result, const Expected& expected) const {
    if (result.steps != expected.steps() && !reference_.cut_short) {
      result.problems.push_back("its session has " + count_text(result.steps, "step") + ", its golden " +
                                number(expected.steps()) + "; bless the case if that is meant");
    }
    for (const std::string& lost : comparer_->lost_channels()) {
      result.problems.push_back(lost + "; bless the case if that is meant");
    }
    for (const std::string& other : comparer_->other_shapes()) {
      result.problems.push_back(other + "; bless the case if that is meant");
    }
    if (expected.body_hashes.empty() || expected.body_hashes.front().id == start_) return;
    result.problems.push_back("its session starts with other bodies: " + number(start_.size()) + ", its golden with " +
                              number(expected.body_hashes.front().id.size()) + "; bless the case if that is meant");
  }

  /// Names the lines of scene.toml that changed since.
  void judge_scene(CaseResult& result, const Expected& expected) {
    const bool has_files = reference_.rules.engine.has_value();
    std::string words = has_files ? "stale: the input files are not those that were blessed"
                                  : "stale: scene.toml is not the scene that was blessed";
    if (expected.scene_text.empty()) {
      words += " (its golden does not keep the scene's text: git's history of scene.toml has it)";
    } else if (!reference_.scene_text.empty()) {
      result.scene_changes = has_files ? file_changes(expected.scene_text, reference_.scene_text)
                                       : scene_changes(expected.scene_text, reference_.scene_text);
      for (std::size_t k = 0; k < std::min(result.scene_changes.size(), kLinesNamed); ++k) {
        words += (k == 0 ? ": " : ", ") + describe(result.scene_changes[k]);
      }
      if (result.scene_changes.size() > kLinesNamed) {
        words += ", and " + number(result.scene_changes.size() - kLinesNamed) + " more lines";
      }
      if (result.scene_changes.empty() && !has_files)
        words += ", and yet no line of it that counts changed: scenes are read otherwise";
    }
    result.problems.push_back(words + "; bless the case if the change is meant, else undo it");
  }

  void judge_behaviour(Judged& judged) {
    CaseResult& result = judged.result;
    Result<std::vector<std::optional<double>>> values = metrics_.finish(last_);
    if (!values.ok()) {
      result.problems.push_back(values.error().message);
      return;
    }
    judged.values = *values;
    const bool same_bits = result.verdict(VerdictKind::kExact).outcome == Outcome::kPass;
    result.verdict(VerdictKind::kBehaviour) = judge_metrics(reference_.rules, judged.values, same_bits, result.metrics);
  }

  replay::LogReader& log_;
  const Reference& reference_;
  std::optional<ExpectedComparer> comparer_;
  replay::ToldWatch told_;
  MetricSet metrics_;
  ExpectedBuilder builder_;
  replay::BodyStates last_;
  std::optional<replay::NotFinite> lost_;  // of the first state in which a body is not finite
  std::vector<sim::BodyId> start_;         // ids of the bodies in state 0
  replay::ContactCheck contacts_;          // of another engine
  Hash128 final_hash_;
  std::uint64_t bodies_ = 0;
};

}  // namespace

Judged judge(replay::LogReader& log, const Reference& reference) { return Pass(log, reference).run(); }

}  // namespace tumble::golden
