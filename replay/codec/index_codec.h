#pragma once

#include <vector>

#include "replay/codec/zstd_frame.h"
#include "tumble/replay/chunk.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The message of the index record. Errors of decoding (kDamaged): a bad pointer, more than kChunksMax rows.
Result<MessageBytes> encode_index(const std::vector<ChunkPlace>& chunks);
Result<std::vector<ChunkPlace>> decode_index(const MessageBytes& message);

}  // namespace tumble::replay
