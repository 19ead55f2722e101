#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "replay/import/table_notes.h"
#include "replay/stream/stream_bodies.h"
#include "replay/stream/stream_step.h"
#include "tumble/replay/engine_log.h"
#include "tumble/sim/result.h"

/// What a stream holds beyond states: channels, contacts, notes, names and shapes.
namespace tumble::replay {

/// Finds the channels of a log for those of a stream, which declares them as it goes and may have several numbers in a
/// value, and tells each step's values. An input that only the engine understands is the channel "input.NAME" of bytes.
class StreamExtras {
 public:
  /// Reads a step for what it declares. Call for every step before declare().
  void survey(const StreamStep& step);
  /// The values that a step's inputs are cut to, whose channels the log needs.
  void survey_told(const ToldValues& told);
  /// Of a step that a rewind took back, only what it declares.
  void survey_channels(const StreamStep& step);

  /// Channels, ascending by name, and the values of `start`. Errors (kBadInput): as EngineLog::create(); a value of a
  /// channel that was not declared.
  /// told: the values of the start that the log's scene cut.
  Result<Declared> declare(const StreamStep& start, const EngineAxes& axes, const ToldValues& told);

  /// Tells the log what the coming step has. Errors (kBadInput): as the functions of EngineLog.
  Status tell(EngineLog& log, const StreamStep& step, const EngineAxes& axes, const ToldValues& told) const;

  /// For people: names that a log cannot have, and contacts that none can be.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  /// A channel of the stream, and the most numbers that a value of it has.
  struct Found {
    StreamChannel channel;
    std::uint32_t count = 1;
  };
  struct Row {
    std::string channel;
    ChannelKey key;
    ChannelValue value;
  };

  /// The channels of the log that one of the stream becomes.
  static std::uint32_t parts_of(const Found& found);
  void fit();
  void rename(Found& found, std::set<std::string>& taken);
  void note_renamed(const char* what, const std::string& name, const std::string& now);
  [[nodiscard]] Result<std::vector<Row>> rows_of(const StreamStep& step, const EngineAxes& axes) const;
  Status add_rows(const StreamValue& value, std::vector<Row>& rows) const;

  std::map<std::uint32_t, Found> found_;
  std::map<std::string, ChannelType> named_inputs_;  // by the channel's name
  std::map<std::string, ChannelType> contact_channels_;
  std::set<std::string> told_;                // channels of told values that the log needs
  std::map<std::string, std::size_t> index_;  // in the log
  std::vector<std::string> notes_;
  ContactCheck contacts_;
};

}  // namespace tumble::replay
