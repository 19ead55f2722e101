#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "replay/format/step_record.h"
#include "replay/log/byte_io.h"
#include "replay/log/log_condition.h"
#include "src/base/result.h"

namespace tumble::replay {

/// What recover_log() wrote, and what it could not save.
struct RecoverReport {
  std::uint64_t first_state = 0;  ///< that the new log begins with
  std::uint64_t last_step = 0;    ///< its last one
  std::uint64_t steps = 0;        ///< saved: those that lie in a chunk
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;  ///< of the new log
  std::vector<Gap> lost;    ///< steps that the session had and the new log has not; ascending
  bool end_known = false;   ///< an index or a footer told the session's last step; otherwise later steps may be lost
  bool header_lost = false;
  std::uint64_t lost_bytes = 0;  ///< of the damaged file
  std::vector<Damage> damages;   ///< by offset

  /// The new log holds all that was recorded.
  [[nodiscard]] bool nothing_lost() const { return lost.empty() && end_known && !header_lost; }
};

/// Writes a whole log of what is left in a damaged one. Chunks are copied byte for byte; where everything is there, so
/// is the header, and the result is the file as it was written. Steps lost between others become a gap that the header
/// names; where the first are lost the log goes on from the first state that is there; a lost header is made anew from
/// it, without names and looks. Errors: kBadInput as salvage(); kDamaged if not one chunk is left; kCannotFinish from
/// writing. Whoever calls it reads the result with verify() before it trusts it.
Result<RecoverReport> recover_log(const ByteSource& damaged, std::unique_ptr<ByteSink> sink);

}  // namespace tumble::replay
