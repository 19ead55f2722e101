#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "replay/recover/salvage.h"
#include "tumble/replay/byte_io.h"
#include "tumble/replay/log_condition.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The result of recover_log(): the saved and the lost steps.
struct RecoverReport {
  std::uint64_t first_state = 0;  ///< the state that the new log begins with
  std::uint64_t last_step = 0;    ///< the last step of the new log
  std::uint64_t steps = 0;        ///< number of saved steps
  std::uint64_t chunks = 0;
  std::uint64_t bytes = 0;         ///< of the new log
  std::vector<MissingSteps> lost;  ///< steps of the session that the new log lacks; ascending
  bool end_known = false;  ///< index or footer state the last step of the session; if false, later steps may be lost
  bool header_lost = false;
  std::uint64_t lost_bytes = 0;  ///< bytes of the damaged file that were not saved
  OtherParts others;             ///< of the file, which the new log lacks
  std::vector<Damage> damages;   ///< by offset

  /// Whether the new log holds everything that was recorded, of this session and of any other that the file has parts
  /// of. Bytes that are part of no whole record may be left over.
  [[nodiscard]] bool nothing_lost() const {
    return lost.empty() && end_known && !header_lost && others.records == 0 && others.unfit_chunks == 0;
  }
};

/// Writes a new log with all intact chunks of a damaged one. The stored bytes of each chunk are copied.
/// - Nothing lost: the header is copied too, and the new log is equal to the original file.
/// - Steps lost between others: the new header lists these missing steps.
/// - First steps lost: the new log continues the session from the first saved state.
/// - Header lost: the new header is rebuilt from the first saved state, without names and looks.
///
/// Errors. kBadInput: as salvage(). kDamaged: no chunk is left. kCannotFinish: writing fails. Call verify() on the new
/// log before trusting it.
Result<RecoverReport> recover_log(const ByteSource& damaged, std::unique_ptr<ByteSink> sink);

}  // namespace tumble::replay
