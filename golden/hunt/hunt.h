#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>

#include "golden/hunt/folder.h"
#include "golden/hunt/judge_scene.h"
#include "tumble/process/job_pool.h"
#include "tumble/sim/result.h"

namespace tumble::hunt {

struct HuntOptions {
  std::uint64_t seed = 1;
  Share share;
  std::optional<std::uint64_t> count;  ///< of scenes 0 … count − 1, those of a kept hunt included, the share's own
  std::optional<double> seconds;       ///< of wall time; none of both: one minute
  Question question;
  std::filesystem::path folder;     ///< keeps the hunt; empty: nothing is kept
  std::filesystem::path corpus;     ///< grows by scenes that broke nothing and do something new; empty: none
  std::uint64_t shrunk_most = 3;    ///< of each relation and phase; the others are named by their number alone
  std::uint64_t tries_most = 4000;  ///< scenes judged to shrink one
  process::PoolOptions pool;        ///< jobs at a time; `cancel` ends the hunt, what is judged stays
  /// Called after each round with the hunt so far, and with each new finding.
  std::function<void(const HuntState& state)> progress;
  std::function<void(const Finding& finding)> found;
};

/// Judges random scenes in child processes, so that a scene that ends or hangs the program is a finding like others.
/// Which scenes break what depends on the seed alone, and on no number of jobs. A hunt that is cancelled or out of time
/// keeps a whole number of scenes without a gap. Where there is a time, shrinking ends with it, and keeps what it has
/// reached. Errors: the folder's; kBadInput: a question that cannot be asked, a folder in which another process hunts.
Result<HuntState> hunt_scenes(const HuntOptions& chosen);

}  // namespace tumble::hunt
