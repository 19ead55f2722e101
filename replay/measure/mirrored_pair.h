#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "replay/measure/measure.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/progress.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/result.h"
#include "tumble/sim/transform.h"

/// A mirrored pair: the session of a scene, and the session of the same scene after a transform (a mirror, a shift,
/// other ids). The second session must be the transform of the first in every state.
namespace tumble::replay {

struct PairReport {
  std::uint64_t steps = 0;  ///< compared, beside the start
  /// m: the largest distance of a body from its expected place, over all states; kNoPartner where a body has no
  /// partner; NaN where a body is not finite.
  double error = 0;
  std::uint64_t differing = 0;  ///< bodies that in any state differed in any bit from the transformed original
  std::optional<std::uint64_t> first_step;  ///< after which a body differed; none: all states are exact
};

/// The error of a body that exists in one session only, m: the width of the world, more than any distance in it.
inline constexpr double kNoPartner = 65'536;

/// Compares the states of a mirrored pair, step by step.
class PairMeter {
 public:
  /// transform and ids turn the first session into the second.
  PairMeter(const sim::Transform& transform, sim::IdMap ids) : transform_(transform), ids_(std::move(ids)) {}

  /// Takes the states of both after a step.
  void add(std::uint64_t step, const BodyStates& original, const BodyStates& transformed);

  [[nodiscard]] const PairReport& report() const { return report_; }

 private:
  void differs(std::uint64_t step, sim::BodyId id, double distance);

  sim::Transform transform_;
  sim::IdMap ids_;
  std::set<sim::BodyId> differing_;
  PairReport report_;
};

/// Steps a scene and its transform in turn, without files: scene.steps steps with the scene's inputs. Errors:
/// Session::start's, Session::step's; kCannotFinish where `progress` stops.
Result<PairReport> run_mirrored_pair(const sim::SceneDef& scene, const sim::Transform& transform,
                                     const Progress& progress = {});

/// Compares two logs. `record` with --mirror, --permute or --shift writes the transform into the header of the second
/// log. Errors: logs that cannot be read; a first log that has a transform, a second one of another scene (kBadInput);
/// kCannotFinish where `progress` stops.
Result<PairReport> compare_mirrored_pair(LogReader& original, LogReader& transformed, const Progress& progress = {});

/// Stores the error in the metrics of the transform: mirror_error for a reflection, order_error for other ids,
/// shift_error for a shift; a mixture sets several.
void set_pair_error(const sim::Transform& transform, const PairReport& report, SymmetryMetrics& metrics);

}  // namespace tumble::replay
