#include "tools/engine/session_watch.h"

#include <algorithm>
#include <iostream>

#include "golden/engine/session_file.h"
#include "tools/files/log_files.h"
#include "tools/output/text.h"
#include "tumble/replay/compare.h"

namespace tumble::tools {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(100);
constexpr auto kSilence = std::chrono::seconds(10);
constexpr int kShareOfLooks = 4;  // one part looking, so many parts not

}  // namespace

void SessionWatch::begin(const std::string& session, const std::string& converted,
                         const golden::EngineProject& project) {
  project_ = &project;
  session_ = session;
  converted_ = converted;
  grown_ = Clock::now();
  next_ = grown_ + kBetweenLooks;
}

/// Tells once where an engine that may hang stands.
void SessionWatch::warn_of_silence(Clock::time_point now) {
  if (warned_ || now - grown_ < kSilence) return;
  warned_ = true;
  bar_.finish();
  std::cerr << "tumble replay: the engine has written "
            << (last_step_ == 0 ? std::string("no step") : "no step behind " + std::to_string(last_step_)) << " for "
            << kSilence.count() << " s (--timeout S ends it)\n";
}

bool SessionWatch::look() {
  if (first_) return stop_;
  const Clock::time_point now = Clock::now();
  if (now < next_) return false;
  look_once();
  const Clock::time_point then = Clock::now();
  next_ = then + std::max<Clock::duration>(kBetweenLooks, kShareOfLooks * (then - now));
  if (!first_) {
    warn_of_silence(then);
    return false;
  }
  bar_.finish();
  std::cerr << "tumble replay: step " << first_->step << " differs already"
            << (stop_ ? "; the engine is stopped\n"
                      : "; the engine runs on (--stop ends it at the first difference)\n");
  return stop_;
}

// What cannot be read yet is looked at again later, and judged when the engine has ended.
bool SessionWatch::look_once() {
  const std::optional<std::string> so_far = golden::log_so_far(session_, converted_, &log_, *project_);
  if (!so_far) return false;
  Result<replay::LogReader> again = replay::LogReader::open(*so_far);
  if (!again.ok() || !again->header().engine || again->last_step() <= again->first_state()) return false;
  if (again->last_step() > last_step_) grown_ = Clock::now();
  last_step_ = again->last_step();
  const std::uint64_t last = std::min(last_step_, log_.last_step());
  Result<replay::DiffReport> report = replay::diff_logs(log_, *again, {}, {}, replay::Reading::kHashes, last);
  if (!report.ok()) return false;
  so_far_ = *so_far;
  if (report->first) first_ = std::move(report->first);
  bar_.show(last - log_.first_state(), log_.step_count());
  return true;
}

}  // namespace tumble::tools
