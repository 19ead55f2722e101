#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>

#include "replay/format/limits.h"
#include "tumble/replay/log_writer.h"

namespace tumble::replay {

/// The chunk that the caller of LogWriter fills, buffer by buffer: how much of it is there, and whether it is full.
struct OpenChunk {
  using Clock = std::chrono::steady_clock;
  static constexpr std::chrono::seconds kAgeMax{1};

  std::uint64_t first_state = 0;  ///< the state before its first step
  std::uint64_t steps = 0;
  std::uint64_t busy_rows = 0;  ///< body-steps that moved
  std::uint64_t bytes = 0;
  std::size_t channels = 0;  ///< of the step with the most
  Clock::time_point begun = Clock::now();

  /// The number of the state after the last added step.
  [[nodiscard]] std::uint64_t last_state() const { return first_state + steps; }

  /// Adds a step; its bytes in memory.
  std::uint64_t add(const StepInfo& info, const sim::Bodies& bodies) {
    const std::uint64_t before = bytes;
    ++steps;
    if (info.extras != nullptr) {
      bytes += bytes_of(*info.extras);
      channels = std::max(channels, info.extras->channels.size());
    }
    busy_rows += static_cast<std::uint64_t>(std::count(bodies.frozen.begin(), bodies.frozen.end(), 0));
    bytes += bodies.size() * kBodyStateBytes + info.phase_words.size() * 8;
    return bytes - before;
  }

  [[nodiscard]] bool full(std::size_t bodies) const {
    return steps >= kChunkStepsMax || busy_rows >= kChunkBusySteps * std::max<std::size_t>(bodies, 1) ||
           (steps + 1) * channels > kChannelStepsMax || bytes >= kChunkStateBytes || Clock::now() - begun >= kAgeMax;
  }
};

/// How many steps a buffer of LogWriter holds, and how many buffers there are, in a world of so many bodies.
struct BufferSizes {
  static constexpr std::uint64_t kBytes = 1 << 20;        // of a buffer, but for one step at least
  static constexpr std::uint64_t kStepsAhead = 128;       // as long as the thread may take for the end of a chunk
  static constexpr std::uint64_t kBytesAhead = 64 << 20;  // of all buffers, but for three at least
  static constexpr std::uint64_t kManyBodies = 1 << 19;   // a keyframe takes 0.5 kB of each: one must do

  explicit BufferSizes(std::uint64_t bodies) {
    const std::uint64_t of_step = kBodyStateBytes * std::max<std::uint64_t>(bodies, 1);
    steps = std::clamp<std::uint64_t>(kBytes / of_step, 1, kChunkBusySteps);
    const std::uint64_t ahead = std::min(kStepsAhead / steps, kBytesAhead / (steps * of_step));
    buffers = bodies < kManyBodies ? std::max<std::uint64_t>(ahead, 3) : 1;
    bytes_ahead = std::max(3 * kChunkStateBytes, 3 * steps * of_step);
  }

  std::uint64_t steps;
  std::uint64_t buffers;
  std::uint64_t bytes_ahead;  ///< that full buffers may hold: snapshots and channels of an engine can be large
};

}  // namespace tumble::replay
