#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "replay/stream/stream_format.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/imported_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

/// The frames of a recorder's stream, checked one by one; stream_step.h reads what a frame holds.
namespace tumble::replay {

class StreamCursor;

/// What the recorder was created with.
struct StreamHeader {
  EngineName engine;
  std::string scene;
  EngineAxes axes;
  sim::Vec3 gravity = {0, 0, 0};  ///< in the engine's axes and unit
  bool ground = false;
  bool hashes_only = false;
  bool ring = false;
  std::vector<std::string> phases;
};

/// A frame whose hash is right.
struct StreamFrame {
  StreamFrameKind kind = StreamFrameKind::kHeader;
  std::uint64_t offset = 0;  ///< of its payload in the stream
  std::uint64_t size = 0;    ///< of its payload, bytes
  std::uint64_t step = 0;    ///< the first number of the payload
};

/// How a stream ends.
struct StreamCondition {
  bool finished = false;  ///< with the frame that the recorder writes last
  bool dumped = false;    ///< of a ring, whose recorder went on
  bool torn = false;      ///< within a frame: the writer was stopped
  std::string
      refusal;  ///< why the recorder took no further call, as tumble_rec_message() has it; empty: it did not say
  std::uint64_t good_bytes = 0;
  std::optional<std::string> damage;  ///< a frame that is not as it was written; what follows it was not read
};

/// A step that a rewind took back, and the frame that replaced it.
struct SupersededStep {
  StreamFrame before;
  StreamFrame after;
};

class StreamReader {
 public:
  static bool is_stream(std::span<const std::byte> first_bytes);

  /// Reads every frame and checks its hash. Errors. kBadInput: no stream, a newer format. kDamaged: no header.
  static Result<StreamReader> open(std::unique_ptr<ByteSource> source);

  [[nodiscard]] const StreamHeader& header() const { return header_; }
  [[nodiscard]] const StreamCondition& condition() const { return condition_; }
  [[nodiscard]] std::string name() const { return source_->name(); }

  /// The start, then the steps with ascending numbers as they were recorded last. Empty: nothing whole was written.
  [[nodiscard]] const std::vector<StreamFrame>& steps() const { return steps_; }
  [[nodiscard]] const std::vector<SupersededStep>& superseded() const { return superseded_; }
  /// Every step that a rewind took back. What it declared holds on.
  [[nodiscard]] const std::vector<StreamFrame>& rewound() const { return rewound_; }
  [[nodiscard]] const std::vector<StreamFrame>& snapshots() const { return snapshots_; }
  [[nodiscard]] std::uint64_t rewinds() const { return rewinds_; }

  /// The payload of a frame. Errors (kCannotFinish): the source cannot be read any more.
  Result<std::vector<std::byte>> read(const StreamFrame& frame) const;

 private:
  explicit StreamReader(std::unique_ptr<ByteSource> source) : source_(std::move(source)) {}
  Status read_prelude();
  Status read_frames();
  Result<bool> read_frame(std::uint64_t& at, std::uint64_t number);
  Status take(const StreamFrame& frame, std::span<const std::byte> payload);
  Status take_step(const StreamFrame& frame);
  Status take_rewind(std::uint64_t step);
  void take_snapshot(const StreamFrame& frame, StreamCursor in);
  bool damage(std::uint64_t at, const std::string& what);

  std::unique_ptr<ByteSource> source_;
  StreamHeader header_;
  StreamCondition condition_;
  std::vector<StreamFrame> steps_;
  std::vector<StreamFrame> taken_back_;  // by the last rewind, not recorded again yet; descending steps
  std::vector<SupersededStep> superseded_;
  std::vector<StreamFrame> rewound_;
  std::vector<StreamFrame> snapshots_;
  std::uint64_t rewinds_ = 0;
  std::uint64_t tag_ = 0;  // hash of the header's frame
  std::uint64_t next_number_ = 0;
};

}  // namespace tumble::replay
