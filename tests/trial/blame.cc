// blame_trial FOLDER LOG...: takes the session of each log again, which another build recorded; at the first step with
// another state of a body, asks blame for five answers about the first value that differs. Of the log it is given,
// blame sees nothing. Prints a line for each log that differs: name, step, body, field, and the phases of the answers.
// tools/scripts/faults/blame.sh builds it with planted faults.
#include "replay/blame/blame.h"

#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

#include "tumble/replay/divergence.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/recorder.h"

namespace tumble::replay {
namespace {

constexpr std::uint32_t kAnswers = 5;

void ask(const std::string& path, const Divergence& first) {
  std::cout << ' ' << first.step << " body " << first.body.value_or(0) << ' ' << first.field << ':';
  if (!first.body || is_body_missing(first)) {
    std::cout << " no value of a body\n";
    return;
  }
  Result<LogReader> log = LogReader::open(path);
  const Result<Blame> found =
      log.ok() ? blame(*log, {*first.body, first.field, first.step, kAnswers}) : Result<Blame>(log.error());
  if (!found.ok()) {
    std::cout << " error: " << found.error().message << '\n';
    return;
  }
  for (const BlameAnswer& answer : found->answers) std::cout << ' ' << answer.phase;
  std::cout << '\n';
}

Status compare(const std::string& path, const std::string& own_path) {
  const std::string name = std::filesystem::path(path).stem().string();
  Result<LogReader> good = LogReader::open(path);
  if (!good.ok()) return good.error();
  auto recorder = Recorder::start(own_path, good->header().scene, {});
  if (!recorder.ok()) return recorder.error();
  for (std::uint64_t k = 1; k <= good->last_step(); ++k) {
    if (Status ok = (*recorder)->step(); !ok.ok()) {
      std::cout << name << ' ' << k << ": stopped: " << ok.error().message << '\n';
      return {};
    }
    const Result<const StepRecord*> record = good->read_step(k);
    if (!record.ok()) return record.error();
    BodyStates own;
    copy_visible((*recorder)->world().bodies(), own);
    std::optional<Divergence> first = first_difference((*record)->states, own);
    if (!first) continue;
    first->step = k;
    if (const Result<LogSummary> done = (*recorder)->finish(); !done.ok()) return done.error();
    std::cout << name;
    ask(own_path, *first);
    return {};
  }
  return {};
}

}  // namespace

// Compares each log of words[2] and on with this build.
int try_blame(int count, char** words) {
  if (count < 3) {
    std::cerr << "usage: blame_trial FOLDER LOG...\n";
    return 2;
  }
  for (int k = 2; k < count; ++k) {
    const Status done = compare(words[k], std::string(words[1]) + "/own.tumble");
    if (done.ok()) continue;
    std::cerr << "blame_trial: " << words[k] << ": " << done.error().message << '\n';
    return 4;
  }
  return 0;
}

}  // namespace tumble::replay

int main(int count, char** words) { return tumble::replay::try_blame(count, words); }
