#include "tools/view/served_log.h"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "replay/blame/blame.h"
#include "replay/view/state_frame.h"
#include "tools/compare/blame_output.h"
#include "tools/view/body_json.h"
#include "tools/view/view_json.h"

#if defined(__linux__)
#include <sched.h>
#include <unistd.h>
#endif

namespace tumble::tools {
namespace {

using Lock = std::lock_guard<std::mutex>;

constexpr std::uint64_t kHistoryBodyStates = 400'000;  // that one question about a body's history reads

constexpr int kBackgroundNice = 5;  // of the thread that reads the timeline

constexpr auto kPause = std::chrono::milliseconds(250);  // between two looks at a log that may grow

/// Whether a log that was opened again has more to read.
bool has_more(const replay::LogReader& again, const replay::LogReader& log) {
  return again.last_step() > log.last_step() || again.condition().finished != log.condition().finished;
}

// Lets every other thread go first: whoever waits for an answer does not wait for the timeline.
void yield_to_others() {
#if defined(__linux__)
  // Both of the calling thread alone, under Linux.
  const sched_param none = {};
  (void)::sched_setscheduler(0, SCHED_BATCH, &none);
  (void)::nice(kBackgroundNice);
#endif
}

}  // namespace

ServedLog::ServedLog(replay::LogReader reader, std::vector<replay::ViewedBound> bounds)
    : path_(reader.name()),
      tag_(reader.header_prelude().log_tag),
      bounds_(std::move(bounds)),
      channels_(replay::channel_columns(reader.header())),
      log_(std::move(reader)),
      table_(log_.header()),
      reached_(log_.last_step()),
      thread_([this] { work(); }) {
  const Lock lock(reading_);
  states_.emplace(log_);
}

ServedLog::~ServedLog() {
  stop_ = true;
  thread_.join();
}

Result<replay::LogReader> ServedLog::open() const {
  Result<replay::LogReader> log = replay::LogReader::open(path_);
  if (!log.ok()) return log;
  if (log->header_prelude().log_tag != tag_) {
    return bad_input(path_ + ": another log lies here now; start 'tumble view' again");
  }
  const Lock lock(found_);
  if (log->last_step() < reached_) {
    return bad_input(path_ + ": was cut while it was shown: its last step is " + std::to_string(log->last_step()) +
                     " now, and was " + std::to_string(reached_) + "; start 'tumble view' again");
  }
  return log;
}

std::optional<replay::LogReader> ServedLog::opened_again(const replay::LogReader& log) {
  Result<replay::LogReader> again = open();
  const Lock lock(found_);
  note_ = again.ok() ? "" : printable(again.error().message);
  if (!again.ok() || !has_more(*again, log)) return std::nullopt;
  reached_ = std::max(reached_, again->last_step());
  return std::optional(*std::move(again));
}

// Requires reading_.
void ServedLog::refresh() {
  if (!log_.condition().finished) {
    if (std::optional<replay::LogReader> again = opened_again(log_)) {
      states_.reset();
      log_ = *std::move(again);
      states_.emplace(log_);
    }
  }
  const Lock lock(found_);
  for (; inputs_seen_ < inputs_.size(); ++inputs_seen_) table_.add({inputs_[inputs_seen_].input});
  for (const replay::Extras& extras : std::exchange(extras_, {})) table_.add({}, extras);
}

Json ServedLog::head() {
  const Lock lock(reading_);
  refresh();
  return head_json(log_);
}

Json ServedLog::bodies() {
  const Lock lock(reading_);
  refresh();
  return bodies_json(table_);
}

Json ServedLog::news() {
  const Lock lock(reading_);
  refresh();
  const Lock found(found_);
  return {{"last", log_.last_step()},
          {"finished", log_.condition().finished},
          {"summary", printable(log_.condition().summary(log_.last_step()))},
          {"rows", rows_.size()},
          {"begun", begun_.size()},
          {"version", table_.version()},
          {"timeline_done", timeline_done_},
          {"contacts_done", contacts_done_},
          {"contacts_why_not", contacts_why_not_},
          {"note", note_},
          {"unread", unread_}};
}

Json ServedLog::timeline(std::size_t from) {
  const Lock lock(found_);
  const std::size_t begin = std::min(from, rows_.size());
  const std::size_t count = std::min(kRowsMax, rows_.size() - begin);
  Json json = timeline_json(std::span(rows_).subspan(begin, count));
  std::vector<replay::TimelineInput> inputs;
  if (count > 0) {
    const std::uint64_t first = rows_[begin].step, last = rows_[begin + count - 1].step;
    for (const replay::TimelineInput& input : inputs_) {
      if (input.step >= first && input.step <= last) inputs.push_back(input);
    }
  }
  json["more_inputs"] = inputs_json(inputs);
  return json;
}

Json ServedLog::begun(std::size_t from) {
  const Lock lock(found_);
  Json counts = Json::array();
  for (std::size_t i = from; i < std::min(begun_.size(), from + kRowsMax); ++i) counts.push_back(begun_[i]);
  return counts;
}

std::string ServedLog::frames(std::uint64_t first, std::uint64_t count, std::uint64_t stride) {
  const Lock lock(reading_);
  refresh();
  std::string out;
  for (std::uint64_t i = 0; i < count && first <= log_.last_step() && out.size() < kFrameBytesMax; ++i) {
    const Result<const replay::StepRecord*> record = states_->read(first);
    if (record.ok()) {
      // The table learns of throws from the step itself too, ahead of the second thread.
      table_.add((*record)->inputs, (*record)->extras);
      replay::append_frame(first, replay::FrameStatus::kShown, &(*record)->states, table_, out);
    } else {
      const auto status = log_.holds(first) ? replay::FrameStatus::kUnread : replay::FrameStatus::kNotHeld;
      replay::append_frame(first, status, nullptr, table_, out);
    }
    if (first > log_.last_step() - std::min(stride, log_.last_step())) break;
    first += stride;
  }
  return out;
}

Json ServedLog::contacts(std::uint64_t k) {
  const Lock lock(touching_);
  if (const Status ready = contacts_.prepare(k); !ready.ok()) {
    return {{"step", k}, {"why_not", printable(ready.error().message)}};
  }
  const Result<std::vector<replay::ContactPoint>> points = contacts_.source().read(k);
  if (!points.ok()) return {{"step", k}, {"why_not", printable(points.error().message)}};
  return {{"step", k}, {"rows", contact_rows_json(*points)}};
}

Json ServedLog::body(std::uint64_t k, sim::BodyId id) {
  const Lock lock(reading_);
  const Result<const replay::StepRecord*> record = states_->read(k);
  if (!record.ok()) return {{"why_not", printable(record.error().message)}};
  Json json = body_json(**record, id, log_.header().declared.channels);
  if (json.is_null()) return {{"why_not", "the state has no such body"}, {"absent", true}};
  return json;
}

Json ServedLog::blame(std::uint64_t k, sim::BodyId id, const std::string& field, std::uint32_t answers) {
  const Lock lock(blaming_);
  Result<replay::LogReader> log = open();
  if (!log.ok()) return {{"why_not", printable(log.error().message)}};
  const Result<replay::Blame> account =
      replay::blame(*log, {id, field, k, answers}, [this](std::uint64_t, std::uint64_t) { return !stop_; });
  if (!account.ok()) return {{"why_not", printable(account.error().message)}};
  return blame_json(*account);
}

Json ServedLog::history(sim::BodyId id, std::uint64_t from) {
  const Lock lock(telling_);
  if (const Status ready = history_.prepare(from); !ready.ok()) return {{"why_not", printable(ready.error().message)}};
  return history_json(from, replay::body_history(history_.source(), history_.log(), id, from, kHistoryBodyStates));
}

Json ServedLog::channel(std::size_t channel, const replay::ChannelKey& owner, std::uint64_t from) {
  const Lock lock(telling_);
  if (const Status ready = history_.prepare(from); !ready.ok()) return {{"why_not", printable(ready.error().message)}};
  return channel_history_json(from, replay::channel_history(history_.source(), history_.log(), channels_.at(channel),
                                                            owner, from, kHistoryBodyStates));
}

Json ServedLog::way(sim::BodyId id) {
  const Lock lock(found_);
  const BodyWays::Way way = ways_.way(id);
  Json at = Json::array();
  for (const float metres : way.at) at.push_back(short_json(metres));
  return {{"id", id}, {"step", way.step}, {"at", at}};
}

// Reads the log by a reader of its own, so that a seek waits for one step at most.
void ServedLog::work() {
  yield_to_others();
  Result<replay::LogReader> opened = open();
  if (!opened.ok()) {
    const Lock lock(found_);
    note_ = unread_ = printable(opened.error().message);
    timeline_done_ = contacts_done_ = true;
    return;
  }
  replay::LogReader log = *std::move(opened);
  replay::TimelineScan scan(log, bounds_);
  std::optional<replay::ContactScan> contacts(std::in_place, log);
  bool counts = !log.header().engine;
  while (!stop_) {
    if (!scan.done()) {
      const replay::TimelineRow row = scan.next();
      const std::vector<sim::Command> inputs = scan.inputs();
      const Lock lock(found_);
      rows_.push_back(row);
      for (const sim::Command& input : inputs) inputs_.push_back({row.step, input});
      if (scan.record() != nullptr) {  // a chunk's new shapes are told with its first step, ahead of their bodies
        const replay::Extras& told = scan.record()->extras;
        if (!told.bodies.empty() || !told.shapes.empty()) extras_.push_back(told);
      }
      if (scan.states() != nullptr) ways_.add(row.step, *scan.states());
      continue;
    }
    if (counts && !contacts->done()) {
      const Result<replay::ContactScan::Row> row = contacts->next();
      const Lock lock(found_);
      timeline_done_ = log.condition().finished;
      if (row.ok()) {
        if (begun_.empty()) begun_.push_back(0);  // of the first state, which no step led to
        begun_.push_back(row->begun);
      } else {
        contacts_why_not_ = printable(row.error().message);
        counts = false;
      }
      continue;
    }
    if (log.condition().finished) break;
    std::this_thread::sleep_for(kPause);
    if (std::optional<replay::LogReader> again = opened_again(log)) {
      log = *std::move(again);
      scan.follow(log);
      contacts->follow(log);
    }
  }
  const Lock lock(found_);
  timeline_done_ = contacts_done_ = true;
}

}  // namespace tumble::tools
