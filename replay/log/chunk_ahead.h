#pragma once

#include <cstddef>
#include <future>
#include <optional>

#include "replay/codec/chunk_codec.h"
#include "replay/log/record_reader.h"
#include "tumble/replay/chunk.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Decodes one chunk of a log on a thread of its own while the chunk before is in use.
class ChunkAhead {
 public:
  /// The reader's source must outlive this object.
  ChunkAhead(const RecordReader& records, const ChunkRules& rules) : records_(records), rules_(rules) {}

  /// Begins to decode chunk number `chunk`. Does nothing where the system gives no thread.
  void begin(std::size_t chunk, const ChunkPlace& place);

  /// Waits for the chunk and returns what RecordReader::read_chunk() returns; none if that chunk was not begun.
  std::optional<Result<ChunkDecoder>> take(std::size_t chunk);

 private:
  RecordReader records_;
  ChunkRules rules_;
  std::size_t chunk_ = 0;
  std::future<Result<ChunkDecoder>> decoder_;
};

}  // namespace tumble::replay
