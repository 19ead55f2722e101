#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/format/chunk.h"
#include "replay/format/prelude.h"
#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/log_condition.h"

namespace tumble::replay {

/// What a walk from prelude to prelude finds, without index and footer.
struct Scan {
  std::vector<ChunkPlace> chunks;  ///< complete by length; their bytes are not hashed yet
  std::optional<ChunkPlace> index;
  std::optional<Footer> footer;
  std::uint64_t footer_offset = 0;
  LogCondition condition;
};

/// Walks the records behind the header. A record that is damaged is skipped: the walk goes on at the next prelude of
/// the same log. `gaps`: what the header says is missing.
Scan scan_records(const ByteSource& source, const Prelude& header, const std::vector<Gap>& gaps);

struct FoundPrelude {
  std::uint64_t offset = 0;
  Prelude prelude;
};

/// The first whole prelude at or after byte `from`: of the log with this tag, or of any if there is none.
std::optional<FoundPrelude> find_prelude(const ByteSource& source, std::uint64_t from,
                                         std::optional<std::uint64_t> log_tag);

}  // namespace tumble::replay
