#include "replay/live/live_logs.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "tumble/replay/log_reader.h"

namespace tumble::replay {
namespace {

constexpr const char* kEnding = ".tumble";

}  // namespace

// A log that exists is never replaced: what was played cannot be played again by hand.
std::string LiveLogs::unused_path(const std::string& ending) const {
  std::string path = root_ + ending + kEnding;
  std::error_code error;
  for (int k = 2; std::filesystem::exists(path, error); ++k) {
    path = root_ + ending + "_" + std::to_string(k) + kEnding;
  }
  return path;
}

Status LiveLogs::accept(Result<std::unique_ptr<Recorder>> opened, const std::string& path, double time_s) {
  if (!opened.ok()) return opened.error();
  recorder_ = *std::move(opened);
  path_ = path;
  clock_ = {};
  if (time_s > 0) clock_.add_step(time_s);
  line_.push_back({path, recorder_->world().state().step, {time_s}});
  return {};
}

Status LiveLogs::open(const std::string& path) {
  root_ = path.ends_with(kEnding) ? path.substr(0, path.size() - std::string_view(kEnding).size()) : path;
  return accept(begin_(path), path, 0);
}

Status LiveLogs::finish() {
  if (recorder_ == nullptr) return {};
  const Result<LogSummary> summary = recorder_->finish();
  recorder_.reset();
  if (!summary.ok()) return summary.error();
  saved_.push_back({path_, line_.back().first_state, *summary});
  return {};
}

Status LiveLogs::again() {
  if (Status ok = finish(); !ok.ok()) return ok;
  line_.clear();
  const std::string path = unused_path("_again");
  return accept(begin_(path), path, 0);
}

Status LiveLogs::back(double seconds) {
  const double wanted = time() - seconds;
  if (Status ok = finish(); !ok.ok()) return ok;
  if (line_.empty()) return cannot_finish("no log to go back in; begin again first");
  while (line_.size() > 1 && line_.back().times.front() > wanted) line_.pop_back();
  Part& part = line_.back();
  const auto after = std::upper_bound(part.times.begin(), part.times.end(), wanted);
  const auto at = after == part.times.begin() ? after : after - 1;
  const std::uint64_t step = part.first_state + static_cast<std::uint64_t>(at - part.times.begin());
  const double time_s = *at;
  part.times.erase(at + 1, part.times.end());
  Result<LogReader> log = LogReader::open(part.path);
  if (!log.ok()) return log.error();
  GoOnOptions how = {.states = states_};
  how.planned_only = true;
  // The scene's own end may lie behind; a played session has none.
  if (log->header().scene.steps <= step) how.steps = 1;
  const std::string path = unused_path("_from_" + std::to_string(step));
  return accept(Recorder::go_on(path, *log, step, how), path, time_s);
}

void LiveLogs::note_step(double dt_s) {
  clock_.add_step(dt_s);
  line_.back().times.push_back(clock_.now());
}

}  // namespace tumble::replay
