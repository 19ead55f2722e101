#pragma once

#include <cstddef>
#include <future>
#include <optional>

#include "replay/codec/chunk_codec.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/scan.h"
#include "src/base/result.h"

namespace tumble::replay {

/// Decodes one chunk of a log on a thread of its own, while the one before it is in use.
class ChunkAhead {
 public:
  /// `source` must outlive it.
  ChunkAhead(const ByteSource& source, const Prelude& header, const LogHeader& log)
      : source_(source), header_(header), log_(log) {}

  /// Begins to decode a chunk; where the system gives no thread, nothing happens.
  void begin(std::size_t chunk, const ChunkPlace& place);

  /// The chunk, as read_chunk() gives it; nothing if it is not the one that was begun.
  std::optional<Result<ChunkDecoder>> take(std::size_t chunk);

 private:
  const ByteSource& source_;
  Prelude header_;
  LogHeader log_;
  std::size_t chunk_ = 0;
  std::future<Result<ChunkDecoder>> decoder_;
};

}  // namespace tumble::replay
