#include "golden/hunt/hunt.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "golden/bundle/file_hashes.h"
#include "golden/hunt/batch.h"
#include "golden/hunt/corpus.h"
#include "golden/hunt/scene/grammar.h"
#include "golden/suite/temporary_folder.h"
#include "src/files/file_lock.h"
#include "tumble/golden/provenance.h"

namespace tumble::hunt {
namespace {

using Clock = std::chrono::steady_clock;

// A round begins with two scenes a batch, and grows while it is short: what a hunt that is killed loses is bounded in
// time.
constexpr std::uint64_t kScenesABatchMost = 10;
constexpr std::uint64_t kBatchesAJob = 4;           // of a round, which lasts as long as its longest one
constexpr double kRoundShort = 2, kRoundLong = 20;  // s
// s of processor time: many times what ten scenes, one scene and the shrinking of one take in a slow build. On a busy
// machine they may take kStretch times as long.
constexpr unsigned kBatchPatience = 120, kScenePatience = 60, kShrinkPatience = 600;
constexpr double kStretch = 20;
constexpr double kUsualSeconds = 60;
constexpr std::uint64_t kRunsKept = 3;  // of each relation and phase: a folder of thousands of findings stays small
constexpr double kLateMost = 60;        // s after the time, at which a scene that was begun is given up

template <class Sum>
void add_refused(std::uint64_t refused, const std::string& refusal, Sum& sum) {
  sum.refused += refused;
  if (sum.refusal.empty()) sum.refusal = refusal;
}

class Hunt {
 public:
  Hunt(const HuntOptions& options, HuntState state, std::optional<Corpus> corpus)
      : options_(options),
        state_(std::move(state)),
        folder_(options.folder),
        corpus_(std::move(corpus)),
        begin_(Clock::now()) {
    for (const Finding& one : state_.findings) {
      if (one.shrunk()) ++shrunk_[{one.relation, one.judgement.phase}];
      if (!one.engine_files.empty()) ++runs_kept_[{one.relation, one.judgement.phase}];
    }
  }

  Result<HuntState> run() {
    // A smaller --count than the scenes that are judged takes none of them back.
    if (!last() || state_.next <= *last()) state_.count = options_.count;
    if (Status ok = save(); !ok.ok()) return ok.error();
    while (!over()) {
      const auto begin = Clock::now();
      const std::uint64_t most = a_batch_ * kBatchesAJob * options_.pool.jobs;
      const std::uint64_t left = last() ? *last() - state_.next : most;
      if (Status ok = round(std::min(left, most)); !ok.ok()) return ok.error();
      const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
      if (seconds < kRoundShort) a_batch_ = std::min(2 * a_batch_, kScenesABatchMost);
      if (seconds > kRoundLong) a_batch_ = std::max<std::uint64_t>(a_batch_ / 2, 1);
    }
    state_.ended = !cancelled();
    if (Status ok = save(); !ok.ok()) return ok.error();
    return std::move(state_);
  }

 private:
  [[nodiscard]] bool cancelled() const { return options_.pool.cancel && options_.pool.cancel(); }
  [[nodiscard]] bool late(double by = 0) const {
    if (options_.count && !options_.seconds) return false;
    return std::chrono::duration<double>(Clock::now() - begin_).count() >=
           options_.seconds.value_or(kUsualSeconds) + by;
  }
  [[nodiscard]] bool over() const { return cancelled() || late() || (last() && state_.next >= *last()); }
  [[nodiscard]] std::optional<std::uint64_t> last() const {
    return options_.count ? std::optional(state_.share.of(*options_.count)) : std::nullopt;
  }

  [[nodiscard]] process::PoolOptions pool(unsigned patience, bool timed) const {
    process::PoolOptions out = options_.pool;
    out.cpu_s = patience;
    out.timeout_s = kStretch * patience;
    out.cancel = [this, timed] { return cancelled() || (timed && late(kLateMost)); };
    return out;
  }

  // Judges the next scenes and adds them to the state, up to the first that was not judged. Once the time is over each
  // batch ends after the scene that it has begun; the first scene is judged even then, so that every hunt gets on.
  Status round(std::uint64_t scenes) {
    const std::uint64_t first = state_.next;
    const std::uint64_t batches = (scenes + a_batch_ - 1) / a_batch_;
    const auto size = [&](std::uint64_t k) { return std::min(a_batch_, scenes - k * a_batch_); };
    std::map<std::uint64_t, process::JobResult> done;
    process::run_jobs(
        batches,
        [&](std::size_t k) {
          bool at_once = k == 0;
          const auto enough = [&] { return !std::exchange(at_once, false) && late(); };
          return to_text(judge_batch(options_.question, state_.seed, state_.share, first + k * a_batch_, size(k),
                                     corpus_.has_value(), enough));
        },
        [&](std::size_t k, const process::JobResult& result) { done[k] = result; }, pool(kBatchPatience, true));
    std::vector<Finding> fresh;
    std::uint64_t counted = 0;
    for (std::uint64_t k = 0; k < batches && done.contains(k); ++k) {
      Result<Batch> batch = done[k].failure.empty() ? batch_from(done[k].output) : one_by_one(state_.next, size(k));
      if (!batch.ok()) return batch.error();
      if (batch->tallies.size() != state_.relations.size()) break;  // cancelled meanwhile
      counted = k + 1;
      for (std::size_t i = 0; i < batch->tallies.size(); ++i) state_.relations[i].second.add(batch->tallies[i]);
      state_.no_scenes += batch->no_scenes;
      add_refused(batch->refused, batch->refusal, state_);
      state_.next += batch->scenes;
      for (Finding& one : batch->findings) fresh.push_back(std::move(one));
      if (Status ok = grow(*batch); !ok.ok()) return ok;
      if (batch->scenes < size(k)) break;
    }
    tell_beyond(done, counted);
    if (Status ok = keep(std::move(fresh)); !ok.ok()) return ok;
    if (options_.progress) options_.progress(state_);
    return {};
  }

  // What the batches from one on judged, behind a scene that was not judged.
  void tell_beyond(const std::map<std::uint64_t, process::JobResult>& done, std::uint64_t first) {
    state_.beyond = {};
    for (auto at = done.lower_bound(first); at != done.end(); ++at) {
      Result<Batch> batch = batch_from(at->second.output);
      if (!at->second.failure.empty() || !batch.ok()) continue;
      state_.beyond.scenes += batch->scenes;
      for (Finding& one : batch->findings) state_.beyond.findings.push_back(std::move(one));
    }
  }

  // Adds the scenes of a batch that do something new to the corpus.
  Status grow(const Batch& batch) {
    for (const auto& [number, features] : batch.features) {
      const Result<TextScene> scene = drawn_scene(state_.seed, number);
      if (!scene.ok()) return scene.error();
      if (const Result<bool> added = corpus_->add(*scene, features); !added.ok()) return added.error();
    }
    return {};
  }

  // A batch whose process ended: the scene that ended it is found by judging each in a process of its own. Empty where
  // the hunt is cancelled meanwhile.
  Result<Batch> one_by_one(std::uint64_t first, std::uint64_t scenes) {
    Batch sum;
    std::map<std::uint64_t, process::JobResult> done;
    const auto told = [&](std::size_t k) {
      return options_.question.scratch / ("judging-" + std::to_string(first + k));
    };
    const bool all = process::run_jobs(
        scenes,
        [&](std::size_t k) {
          Question question = options_.question;
          question.told = told(k);
          return to_text(judge_batch(question, state_.seed, state_.share, first + k, 1, false, [] { return false; }));
        },
        [&](std::size_t k, const process::JobResult& result) { done[k] = result; }, pool(kScenePatience, false));
    if (!all) return sum;
    sum.scenes = scenes;
    sum.tallies.resize(state_.relations.size());
    for (const auto& [k, result] : done) {
      if (!result.failure.empty()) {
        sum.findings.push_back(finding_of_end(state_.share.number(first + k), result.failure, told_in(told(k))));
        for (Tally& tally : sum.tallies) ++tally.not_applicable;  // no relation was judged to its end
        continue;
      }
      Result<Batch> one = batch_from(result.output);
      if (!one.ok()) return one.error();
      for (std::size_t i = 0; i < one->tallies.size(); ++i) sum.tallies[i].add(one->tallies[i]);
      sum.no_scenes += one->no_scenes;
      add_refused(one->refused, one->refusal, sum);
      for (Finding& finding : one->findings) sum.findings.push_back(std::move(finding));
    }
    return sum;
  }

  [[nodiscard]] Finding finding_of_end(std::uint64_t number, const std::string& failure, std::string judging) const {
    Finding finding;
    finding.seed = state_.seed;
    finding.number = number;
    finding.relation = kSurvives;
    const Result<TextScene> scene = drawn_scene(state_.seed, number);
    if (scene.ok()) finding.kind = scene->scene.title.substr(0, scene->scene.title.find(','));
    finding.judgement = ended(failure, judging, !state_.engine.empty());
    finding.judging = std::move(judging);
    return finding;
  }

  // Shrinks the first findings of each relation and phase, writes all and saves the state.
  Status keep(std::vector<Finding> fresh) {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < fresh.size(); ++k) {
      std::uint64_t& seen = shrunk_[{fresh[k].relation, fresh[k].judgement.phase}];
      if (fresh[k].relation == kSurvives || seen >= options_.shrunk_most) continue;
      ++seen;
      chosen.push_back(k);
    }
    process::run_jobs(
        chosen.size(),
        [&](std::size_t k) {
          const auto enough = [this] { return late(); };
          return whole_text(to_json(shrink_finding(options_.question, fresh[chosen[k]], options_.tries_most, enough)));
        },
        [&](std::size_t k, const process::JobResult& result) {
          if (!result.failure.empty()) return;
          const Json json = Json::parse(result.output, nullptr, false);
          if (!json.is_discarded()) fresh[chosen[k]] = finding_from(json);
        },
        pool(kShrinkPatience, true));
    for (Finding& one : fresh) {
      if (Status ok = write(one); !ok.ok()) return ok;
      if (Status ok = keep_run_of(one); !ok.ok()) return ok;
      if (options_.found) options_.found(one);
      state_.findings.push_back(std::move(one));
    }
    std::error_code ignored;
    if (!options_.question.runs.empty()) std::filesystem::remove_all(options_.question.runs, ignored);
    return save();
  }

  // What the engine wrote and printed in the first scenes that break a relation in a phase.
  Status keep_run_of(Finding& finding) {
    std::uint64_t& seen = runs_kept_[{finding.relation, finding.judgement.phase}];
    if (options_.question.runs.empty() || finding.relation == kSurvives || seen >= kRunsKept) return {};
    ++seen;
    return folder_.keep(options_.question.runs / std::to_string(finding.number), finding);
  }

  [[nodiscard]] Status save() const { return options_.folder.empty() ? Status{} : folder_.save(state_); }

  Status write(const Finding& finding) {
    if (options_.folder.empty()) return {};
    const Result<TextScene> drawn = drawn_scene(finding.seed, finding.number);
    return drawn.ok() ? folder_.write(finding, drawn->text, state_) : Status(drawn.error());
  }

  const HuntOptions& options_;
  HuntState state_;
  Folder folder_;
  std::optional<Corpus> corpus_;
  Clock::time_point begin_;
  std::uint64_t a_batch_ = 2;                                                        // scenes
  std::map<std::pair<std::string, std::string>, std::uint64_t> shrunk_, runs_kept_;  // by relation and phase
};

}  // namespace

Result<HuntState> hunt_scenes(const HuntOptions& chosen) {
  HuntOptions options = chosen;
  if (Status ok = check_question(options.question); !ok.ok()) return ok.error();
  const golden::Provenance program = golden::this_program();
  HuntState fresh;
  fresh.seed = options.seed;
  fresh.share = options.share;
  fresh.grammar = kGrammar;
  fresh.program = program.version + " " + (program.commit.empty() ? "commit not known" : program.commit);
  if (program.tree == "changed") fresh.program += " (sources changed since)";
  fresh.against = options.question.against;
  for (const ApartBound& bound : options.question.within) fresh.within.push_back(to_text(bound));
  if (options.question.engine) {
    fresh.engine = options.question.engine->run;
    fresh.engine_hash = golden::engine_hash(*options.question.engine);
  } else if (!fresh.against.empty()) {
    fresh.engine_hash = golden::program_hash(fresh.against);
  }
  for (const std::string& name : names_of(options.question)) {
    fresh.relations.emplace_back(name, Tally{});
    if (options.question.engine && is_claimed(options.question, name)) fresh.claimed.push_back(name);
  }
  std::optional<Corpus> corpus;
  if (!options.corpus.empty()) {
    Result<Corpus> opened = Corpus::open(options.corpus);
    if (!opened.ok()) return opened.error();
    corpus = *std::move(opened);
  }
  const golden::TemporaryFolder scratch("tumble-hunt");  // goes with this process, however those end that judge
  options.question.scratch = scratch.path();
  const std::filesystem::path& place = options.question.scratch;
  if (options.question.engine && !options.folder.empty() && !place.empty()) options.question.runs = place / "runs";
  if (options.folder.empty()) return Hunt(options, std::move(fresh), std::move(corpus)).run();
  const Result<files::FolderLock> lock = files::FolderLock::take(options.folder, kLockFile, "a hunt");
  if (!lock.ok()) return lock.error();
  Result<HuntState> kept = Folder(options.folder).open(std::move(fresh));
  if (!kept.ok()) return kept.error();
  return Hunt(options, *std::move(kept), std::move(corpus)).run();
}

}  // namespace tumble::hunt
