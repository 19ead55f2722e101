#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>

#include "replay/stream/stream_reader.h"
#include "replay/stream/stream_step.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// States by body.
using StreamStates = std::map<std::uint64_t, StreamState>;

Result<StreamStep> decoded(const StreamReader& stream, const StreamFrame& frame);

/// Whether an input of a step wakes a body: a record "same" of it is then of its last state, but awake.
bool wakes(const StreamStep& step, std::uint64_t id);

/// The last states of bodies before a step that a rewind took back. Remembers what it found, so that many rewinds of a
/// long session read each step about once.
class LastStates {
 public:
  explicit LastStates(const StreamReader& stream) : stream_(stream) {}

  /// Adds to `states` those of these bodies before `frame`; of none where a later rewind replaced the steps that would
  /// tell.
  Status find(const StreamFrame& frame, const std::set<std::uint64_t>& ids, StreamStates& states);

 private:
  struct Known {
    StreamState state;         // as told
    std::uint64_t told = 0;    // the step that told it
    std::uint64_t woken = 0;   // the first step behind it that woke the body; 0: none
    std::uint64_t before = 0;  // the step up to which this is the last
  };
  void see(const StreamStep& step, std::uint64_t before, std::set<std::uint64_t>& ids,
           std::map<std::uint64_t, std::uint64_t>& woken);

  const StreamReader& stream_;
  std::map<std::uint64_t, Known> known_;
};

}  // namespace tumble::replay
