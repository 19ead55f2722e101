#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "replay/diff/compare.h"
#include "replay/diff/step_contacts.h"
#include "replay/log/log_reader.h"

namespace tumble::replay {

/// Where two logs part, as close as logs and this build can say.
struct Narrowing {
  DiffReport report;  ///< with the pair filled in, where it is plain
  // Of the first different step: whether this build, from the log's own state before it, does as the log says.
  bool as_a = false;
  bool as_b = false;
  /// Why it could not be taken again; empty: it was, or there was no step to take.
  std::string not_taken;
  /// What the first different body touched in that step, by the log that this build reproduces (the first one if both).
  std::vector<StepContact> contacts;
  /// Bodies with different states after that step, ascending; empty where a log has no such states and this build
  /// cannot make them.
  std::vector<sim::BodyId> bodies;
  std::uint64_t chunks_opened = 0;  ///< decoded, of both logs
};

/// diff_logs() exactly, then the first different step taken again from both logs: which of them this build follows,
/// what the body touched, body and field also where the logs hold no states. Errors: as diff_logs().
Result<Narrowing> narrow(LogReader& a, LogReader& b, const Progress& progress = {});

/// The same for a comparison that was made already.
Narrowing narrow(LogReader& a, LogReader& b, DiffReport report);

}  // namespace tumble::replay
