#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "tumble/replay/byte_io.h"
#include "tumble/replay/chunk.h"
#include "tumble/replay/log_condition.h"
#include "tumble/replay/prelude.h"
#include "tumble/replay/step_record.h"

namespace tumble::replay {

/// The records of a log, found by following the preludes instead of the index.
struct Scan {
  std::vector<ChunkPlace> chunks;  ///< the file holds all their bytes, which are not hashed yet
  std::optional<ChunkPlace> index;
  std::optional<Footer> footer;
  std::uint64_t footer_offset = 0;
  LogCondition condition;
};

/// Follows the preludes from the end of the header to the end of the file. Skips a damaged record and continues at the
/// next prelude of this log. `missing`: the steps that the header declares missing.
Scan scan_records(const ByteSource& source, const Prelude& header, const std::vector<MissingSteps>& missing);

/// An intact prelude and its place.
struct FoundPrelude {
  std::uint64_t offset = 0;
  Prelude prelude;
};

/// The first intact prelude at or after byte `from`. log_tag: of the wanted log; none accepts every log.
std::optional<FoundPrelude> find_prelude(const ByteSource& source, std::uint64_t from,
                                         std::optional<std::uint64_t> log_tag);

}  // namespace tumble::replay
