#pragma once

#include <map>

#include "replay/log/verify.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Reads every byte of a log before an answer speaks of the log. A torn log and damage that opening found already are
/// no errors: LogReader::condition() has both, and the intact part can be compared. Errors: kDamaged for any other
/// damage, such as changed bytes of a chunk or states that do not match their hashes; kCannotFinish where `progress`
/// stops.
Result<VerifyReport> check_log(LogReader& log, const Progress& progress = {});

/// The reports of check_log(), kept, so that many comparisons read each log from end to end once. The logs must keep
/// their places.
class CheckedLogs {
 public:
  /// Errors: as check_log().
  Result<const VerifyReport*> check(LogReader& log, const Progress& progress = {});

 private:
  std::map<const LogReader*, VerifyReport> reports_;
};

}  // namespace tumble::replay
