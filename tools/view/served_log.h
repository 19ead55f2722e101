#pragma once

#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "replay/session/state_source.h"
#include "replay/view/contact_points.h"
#include "replay/view/timeline.h"
#include "replay/view/viewed_bodies.h"
#include "tools/output/text.h"
#include "tools/view/body_ways.h"
#include "tools/view/own_reader.h"
#include "tumble/replay/channel.h"
#include "tumble/replay/log_reader.h"

namespace tumble::tools {

/// One log that a page asks about: any step at once, while a second thread reads all of them in turn for the timeline.
/// A log that is being recorded is followed to its last chunk. Every member may be called from any thread.
class ServedLog {
 public:
  /// Starts reading. reader: of the log, which lies at its name().
  explicit ServedLog(replay::LogReader reader, std::vector<replay::ViewedBound> bounds = {});
  ~ServedLog();
  ServedLog(const ServedLog&) = delete;
  ServedLog& operator=(const ServedLog&) = delete;

  /// head_json(). Opens the log again where it has grown.
  Json head();
  /// {"last", "finished", "rows", "version", "timeline_done", "contacts_done", "contacts_why_not", "note", "unread"}.
  /// "note": why the log cannot be opened again now; "unread": why the timeline was not read.
  Json news();
  Json bodies();

  /// Rows from the `from`-th on, kRowsMax at most: timeline_json(), and "more_inputs" of those steps.
  Json timeline(std::size_t from);
  /// [number of pairs that begin to touch], of the rows from the `from`-th on that are counted.
  Json begun(std::size_t from);
  static constexpr std::size_t kRowsMax = 4000;

  /// append_frame() of each of the steps first, first + stride, …; fewer than `count` where kFrameBytesMax is reached.
  std::string frames(std::uint64_t first, std::uint64_t count, std::uint64_t stride);
  static constexpr std::size_t kFrameBytesMax = 8 << 20;

  /// {"step", "rows": contact_rows_json()}, or {"step", "why_not"}. May take up to a keyframe's distance of steps
  /// again; other questions go on meanwhile.
  Json contacts(std::uint64_t k);
  /// body_json(), or {"why_not"}.
  Json body(std::uint64_t k, sim::BodyId id);
  /// blame_json() of a value, or {"why_not"}. Takes steps again, one question at a time; other questions go on
  /// meanwhile.
  Json blame(std::uint64_t k, sim::BodyId id, const std::string& field, std::uint32_t answers);
  /// history_json() of the body from step `from` on, a part a call.
  Json history(sim::BodyId id, std::uint64_t from);
  /// channel_history_json() of a body or a pair from step `from` on, a part a call. channel: by index in the head's.
  Json channel(std::size_t channel, const replay::ChannelKey& owner, std::uint64_t from);
  /// How many channels the head has.
  [[nodiscard]] std::size_t channels() const { return channels_.size(); }
  /// {"id", "step", "at": [x, y, z, …]}: where the body was, as far as the timeline has been read.
  Json way(sim::BodyId id);

 private:
  void work();  // the second thread
  void refresh();
  /// A further reader of the log. Errors: LogReader::open()'s; kBadInput where another log lies at its path by now, or
  /// what is left of this one.
  [[nodiscard]] Result<replay::LogReader> open() const;
  /// The log with what was recorded since; none where there is no more, or it cannot be opened, which news() say.
  std::optional<replay::LogReader> opened_again(const replay::LogReader& log);

  const std::string path_;
  const std::uint64_t tag_;
  const std::vector<replay::ViewedBound> bounds_;
  const std::vector<std::size_t> channels_;  // channel_columns()
  std::mutex reading_;                       // guards what follows
  replay::LogReader log_;
  std::optional<replay::StateSource> states_;
  replay::ViewedBodies table_;
  std::size_t inputs_seen_ = 0;  // of inputs_, in table_

  std::mutex blaming_;

  std::mutex touching_;  // guards contacts_
  OwnReader<replay::ContactSource> contacts_{[this] { return open(); }};

  std::mutex telling_;  // guards history_
  OwnReader<replay::StateSource> history_{[this] { return open(); }};

  mutable std::mutex found_;  // guards what follows; locked after reading_
  std::uint64_t reached_;     // the last step that was there
  std::vector<replay::TimelineRow> rows_;
  std::vector<replay::TimelineInput> inputs_;
  std::vector<replay::Extras> extras_;  // names and shapes that table_ does not have yet
  std::vector<std::uint32_t> begun_;
  BodyWays ways_;
  bool timeline_done_ = false;
  bool contacts_done_ = false;
  std::string contacts_why_not_, note_, unread_;

  std::atomic<bool> stop_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace tumble::tools
