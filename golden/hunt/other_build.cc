#include "golden/hunt/other_build.h"

#include <algorithm>
#include <utility>

#include "golden/hunt/apart/log_pair.h"
#include "golden/suite/text_files.h"
#include "src/base/text.h"
#include "src/process/run_child.h"

namespace tumble::hunt {
namespace {

constexpr double kPatience = 60;  // s that another build may take for one scene
constexpr std::size_t kWordsMost = 300;

// The last line that a program printed, to be added to a sentence; empty: it printed none.
std::string last_words(const std::filesystem::path& file) {
  const Result<std::string> text = golden::read_text(file);
  if (!text.ok()) return "";
  std::string last;
  for (const std::string& line : golden::lines_of(*text)) {
    if (!line.empty()) last = line;
  }
  return last.empty() ? "" : ": " + in_quotes(last.substr(0, kWordsMost));
}

}  // namespace

Judgement OtherBuild::judge(const std::string& relation) {
  if (!trace_.failure.empty()) return not_applicable("the session ends early");
  if (!session_) session_ = judge_session();
  const auto bound = std::ranges::find(within_, relation, relation_of);
  if (bound == within_.end()) return *session_;
  if (session_->outcome != Outcome::kHeld) return not_applicable("no whole session to compare with: " + session_->what);
  return pair_->judge(*bound);
}

Judgement OtherBuild::judge_session() {
  Judgement recorded = record();
  if (recorded.outcome != Outcome::kHeld) return recorded;
  return within_.empty() ? compare_bits(trace_, *log_) : read_records();
}

// Records the scene with the other build, in a folder of its own.
Judgement OtherBuild::record() {
  folder_ = std::make_unique<golden::TemporaryFolder>("scene", scratch_);
  const std::filesystem::path& place = folder_->path();
  if (place.empty()) return not_applicable("no temporary folder could be made");
  const std::filesystem::path toml = place / "scene.toml", log = place / "s.tumble", said = place / "said";
  if (const Status ok = golden::write_file(toml, scene_.text); !ok.ok()) return not_applicable(ok.error().message);
  process::Program child;
  child.words = {program_, "record", toml.string(), "-o", log.string()};
  child.own_group = false;  // it ends with the process that judges
  child.out = child.err = said.string();
  const Result<process::ChildEnd> end = process::run_child(child, kPatience);
  if (end.ok() && end->late) process::end_own_group();
  if (!end.ok()) return broken(0, 0, "the other build does not start: " + end.error().message);
  const std::string words = last_words(said);
  if (end->exit == 2) return broken(0, 0, "the other build refuses the scene, which this one records" + words);
  if (end->late) return broken(0, 0, "the other build took longer than " + fixed(kPatience, 0) + " s");
  if (!end->well() && end->exit != 4) return broken(0, 0, "the other build " + end->text() + words);
  Result<replay::LogReader> reader = replay::LogReader::open(log.string());
  if (!reader.ok()) return broken(0, 0, "the other build's log: " + reader.error().message + words);
  log_.emplace(*std::move(reader));
  return held();
}

// All states of the other session, beside those of the trace.
Judgement OtherBuild::read_records() {
  Judgement start = compare_starts(trace_, *log_, Starts::kPlaced);
  if (start.outcome != Outcome::kHeld) return start;
  if (Judgement lengths = compare_lengths(trace_, *log_); lengths.outcome != Outcome::kHeld) return lengths;
  std::vector<replay::StepRecord> other;
  for (std::uint64_t k = 0; k <= trace_.steps.size(); ++k) {
    const Result<const replay::StepRecord*> record = log_->read_step(k);
    if (!record.ok()) return log_unread(k, record.error());
    if (!(*record)->has_states) return broken(k, 0, "the other build's log holds no states of the step");
    other.push_back(**record);
  }
  pair_.emplace(trace_, other);
  return held();
}

}  // namespace tumble::hunt
