#include "golden/canaries/canaries.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "golden/canaries/known_answers.h"
#include "golden/canaries/log_canaries.h"
#include "golden/canaries/lying_log.h"
#include "golden/canaries/suite_canaries.h"
#include "golden/expected/expected_file.h"
#include "golden/run/run_session.h"
#include "golden/suite/scene_hash.h"
#include "tumble/golden/change.h"
#include "tumble/process/job_pool.h"

namespace tumble::golden {
namespace {

constexpr std::uint64_t kSteps = 24;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Three boxes that fall onto each other and the ground; shift: of the middle one, m.
sim::SceneDef tiny_scene(double shift = 0) {
  sim::SceneDef scene;
  scene.name = "canary";
  scene.world.method = sim::Method::kThesis;
  scene.steps = kSteps;
  for (std::uint64_t i = 0; i < 3; ++i) {
    sim::BoxDef box;
    box.id = 1 + i;
    box.position = {0.25 * static_cast<double>(i) + (i == 1 ? shift : 0), 0, 0.55 + 1.05 * static_cast<double>(i)};
    box.spin = {0.25, 0.5, 0};
    scene.boxes.push_back(box);
  }
  return scene;
}

/// A session, its golden and its rules. Each canary spoils one part of a copy.
struct Fixture {
  sim::SceneDef scene = tiny_scene();
  Session session;
  Expected expected;
  bool has_expected = true;
  CaseRules rules;
  Judge judge = nullptr;

  [[nodiscard]] CaseResult run() const {
    CaseResult result;
    Result<replay::LogReader> log = open_session(session, "the canary's log");
    if (!log.ok()) {
      result.problems.push_back(log.error().message);
      return result;
    }
    const Reference reference = {rules, has_expected ? &expected : nullptr, scene_hash(scene), session.continuation};
    result = judge(*log, reference).result;
    result.require = rules.require;
    return result;
  }
};

bool failed(const CaseResult& result, VerdictKind kind) { return result.verdict(kind).outcome == Outcome::kFail; }
bool passed(const CaseResult& result, VerdictKind kind) { return result.verdict(kind).outcome == Outcome::kPass; }

bool only_exact(const CaseResult& r) {
  return failed(r, VerdictKind::kExact) && passed(r, VerdictKind::kBehaviour) && r.problems.empty();
}
bool only_behaviour(const CaseResult& r) {
  return passed(r, VerdictKind::kExact) && failed(r, VerdictKind::kBehaviour) && r.problems.empty();
}
bool bits_moved(const CaseResult& r) { return failed(r, VerdictKind::kExact); }
bool has_problem(const CaseResult& r) { return !r.problems.empty(); }
bool another_length(const CaseResult& r) {
  return failed(r, VerdictKind::kExact) && passed(r, VerdictKind::kBehaviour) && has_problem(r);
}
bool body_is_lost(const CaseResult& r) {
  return passed(r, VerdictKind::kExact) && failed(r, VerdictKind::kBehaviour) && has_problem(r);
}
bool nothing_to_compare(const CaseResult& r) { return !passed(r, VerdictKind::kExact); }
bool no_picture(const CaseResult& r) { return r.verdict(VerdictKind::kImage).outcome != Outcome::kPass; }

struct Canary {
  const char* name;
  void (*spoil)(Fixture& fixture);
  bool (*caught)(const CaseResult& result);  ///< besides: the case must not pass
};

void flip(Hash128& hash) { hash.low ^= 1; }

/// The session as an engine would log it that loses a body in one step. The golden holds the same bits, so that only
/// the metrics can tell.
void lose_body(Fixture& f, std::uint64_t step, std::vector<double>& (*column_of)(sim::Bodies& bodies)) {
  const auto lie = [&](sim::WorldState& state, sim::StepCounters&) {
    column_of(state.bodies)[1] = std::numeric_limits<double>::quiet_NaN();
  };
  Result<replay::MemoryFile> log = record_lying(f.scene, kSteps, step, lie);
  if (!log.ok()) return;
  f.session.log = *std::move(log);
  Result<replay::LogReader> reader = open_session(f.session, "the canary's log");
  if (!reader.ok()) return;
  f.expected = judge(*reader, {f.rules, nullptr, scene_hash(f.scene), f.session.continuation}).actual;
}

const std::vector<Canary>& canaries() {
  static const std::vector<Canary> kCanaries = {
      {"one bit of a state hash differs", [](Fixture& f) { flip(f.expected.state_hashes[kSteps / 2]); }, only_exact},
      {"the first state differs", [](Fixture& f) { flip(f.expected.state_hashes.front()); }, only_exact},
      {"the last state differs", [](Fixture& f) { flip(f.expected.state_hashes.back()); }, only_exact},
      {"the golden has a step less",
       [](Fixture& f) {
         f.expected.state_hashes.pop_back();
         f.expected.step_words.pop_back();
         f.expected.phase_words.pop_back();
       },
       another_length},
      {"the golden has a step more",
       [](Fixture& f) {
         f.expected.state_hashes.push_back(f.expected.state_hashes.back());
         f.expected.step_words.push_back(0);
         f.expected.phase_words.emplace_back();
       },
       another_length},
      {"the golden is empty", [](Fixture& f) { f.expected.state_hashes.clear(); }, has_problem},
      {"there is no golden", [](Fixture& f) { f.has_expected = false; }, nothing_to_compare},
      {"the scene changed since", [](Fixture& f) { f.scene.world.gravity.z() -= 1e-9; }, has_problem},
      {"a phase wrote something else",
       [](Fixture& f) {
         f.expected.phase_words[kSteps / 2][0] ^= 1;
         f.expected.step_words[kSteps / 2] ^= 1;
       },
       only_exact},
      {"phase hashes cover other fields", [](Fixture& f) { ++f.expected.phase_hash_version; }, has_problem},
      {"a counter differs", [](Fixture& f) { f.expected.step_words[kSteps / 2] ^= 1; }, only_exact},
      {"the hidden state differs", [](Fixture& f) { flip(f.expected.continuation); }, only_exact},
      {"a body starts a hair's breadth away",
       [](Fixture& f) { f.session = *run_session(tiny_scene(std::ldexp(1, -36)), ""); }, bits_moved},
      {"a metric lies just above its bound",
       [](Fixture& f) {
         f.rules.metrics[0].min.reset();
         f.rules.metrics[0].max = std::nextafter(*f.rules.metrics[0].value, -kInfinity);
       },
       only_behaviour},
      {"a metric lies just below its bound",
       [](Fixture& f) {
         f.rules.metrics[0].max.reset();
         f.rules.metrics[0].min = std::nextafter(*f.rules.metrics[0].value, kInfinity);
       },
       only_behaviour},
      {"a metric is null", [](Fixture& f) { f.rules.metrics[0].name = "column_spread"; }, only_behaviour},
      {"a metric was never blessed", [](Fixture& f) { f.rules.metrics[0].value.reset(); }, only_behaviour},
      {"a metric moved and no bit did", [](Fixture& f) { *f.rules.metrics[0].value *= 1.001; }, only_behaviour},
      {"there is no metric", [](Fixture& f) { f.rules.metrics.clear(); }, only_behaviour},
      {"a picture is required and there is none", [](Fixture& f) { f.rules.require = {VerdictKind::kImage}; },
       no_picture},
      {"a spin is not a number in one step",
       [](Fixture& f) {
         lose_body(f, kSteps / 2, [](sim::Bodies& bodies) -> std::vector<double>& { return bodies.spin.x; });
       },
       body_is_lost},
      {"a position is not a number at the end",
       [](Fixture& f) {
         lose_body(f, kSteps, [](sim::Bodies& bodies) -> std::vector<double>& { return bodies.position.z; });
       },
       body_is_lost},
      {"the log is damaged", [](Fixture& f) { (*f.session.log)[f.session.log->size() / 2] ^= std::byte{1}; },
       has_problem},
      {"the log is torn", [](Fixture& f) { f.session.log->resize(f.session.log->size() - 1); }, has_problem},
  };
  return kCanaries;
}

std::string words_of(const CaseResult& result) {
  return result.problems.empty() ? summary(result) : result.problems.front();
}

/// A golden file with a spoilt byte or end must not be read.
CanaryResult spoilt_file(const Expected& expected, void (*spoil)(std::vector<std::byte>& file)) {
  Result<std::vector<std::byte>> file = pack(expected);
  if (!file.ok()) return {"", false, file.error().message};
  const Result<Expected> whole = unpack(*file, "the canary's golden");
  spoil(*file);
  const Result<Expected> spoilt = unpack(*file, "the canary's golden");
  return {"", whole.ok() && *whole == expected && !spoilt.ok(), spoilt.ok() ? "read" : spoilt.error().message};
}

CanaryResult dying_child() {
  CanaryResult result{"", false, "it passed as finished"};
  process::run_jobs(
      1, [](std::size_t) -> std::string { std::abort(); },
      [&](std::size_t, const process::JobResult& child) {
        result.caught = !child.failure.empty() && child.output.empty();
        result.message = child.failure;
      },
      {});
  return result;
}

Result<Fixture> make_fixture(Judge judge_function) {
  Fixture fixture;
  fixture.judge = judge_function;
  Result<Session> session = run_session(fixture.scene, "");
  if (!session.ok()) return session.error();
  fixture.session = *std::move(session);
  Result<replay::LogReader> log = open_session(fixture.session, "the canary's log");
  if (!log.ok()) return log.error();
  MetricRule& rule = fixture.rules.metrics.emplace_back();
  rule.name = "drift_max";
  rule.min = 0;
  rule.max = 1000;
  // The real judge makes the golden: a judge that does nothing could otherwise agree with its own empty golden.
  const Judged blessed = judge(*log, {fixture.rules, nullptr, scene_hash(fixture.scene), fixture.session.continuation});
  fixture.expected = blessed.actual;
  if (!blessed.values.empty()) fixture.rules.metrics[0].value = blessed.values[0];
  return fixture;
}

/// Canaries about one session, which is recorded for the first that is asked.
class JudgeCanaries {
 public:
  JudgeCanaries(CanaryRoll& roll, Judge judge_function) : roll_(roll), judge_(judge_function) {}

  template <class Ask>
  void ask(const char* name, Ask&& ask_it) {
    roll_.ask(name, [&]() -> CanaryResult {
      if (!fixture_) fixture_ = make_fixture(judge_);
      return fixture_->ok() ? ask_it(**fixture_) : CanaryResult{"", false, fixture_->error().message};
    });
  }

 private:
  CanaryRoll& roll_;
  Judge judge_;
  std::optional<Result<Fixture>> fixture_;
};

void run_judge_canaries(CanaryRoll& roll, Judge judge_function) {
  JudgeCanaries judged(roll, judge_function);
  judged.ask("nothing is wrong, which must pass", [](const Fixture& fixture) -> CanaryResult {
    const CaseResult control = fixture.run();
    return {"", control.passed(), words_of(control)};
  });
  for (const Canary& canary : canaries()) {
    judged.ask(canary.name, [&canary](const Fixture& fixture) -> CanaryResult {
      Fixture spoilt = fixture;
      spoilt.session.log = std::make_shared<std::vector<std::byte>>(*fixture.session.log);
      canary.spoil(spoilt);
      const CaseResult result = spoilt.run();
      return {"", !result.passed() && canary.caught(result), words_of(result)};
    });
  }
  const auto file = [&judged](const char* name, void (*spoil)(std::vector<std::byte> & file)) {
    judged.ask(name, [spoil](const Fixture& fixture) { return spoilt_file(fixture.expected, spoil); });
  };
  file("a byte of the golden differs", [](std::vector<std::byte>& bytes) { bytes[bytes.size() / 2] ^= std::byte{1}; });
  file("the golden's file is torn", [](std::vector<std::byte>& bytes) { bytes.pop_back(); });
  file("the golden's file is empty", [](std::vector<std::byte>& bytes) { bytes.clear(); });
}

}  // namespace

CanaryRoll run_canaries(Judge judge_function, std::size_t shard, std::size_t shards) {
  CanaryRoll roll(shard, shards);
  run_judge_canaries(roll, judge_function);
  roll.ask("a case crashes", dying_child);
  for (auto* const some : {run_log_canaries, run_suite_canaries, run_known_answers, run_known_drawings, run_known_files,
                           run_known_limits, run_known_pictures, run_known_processes, run_known_refusals,
                           run_known_scenes, run_known_sessions, run_known_snapshots, run_known_worlds}) {
    some(roll);
  }
  return roll;
}

}  // namespace tumble::golden
