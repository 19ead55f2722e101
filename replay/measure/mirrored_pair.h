#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "replay/format/step_record.h"
#include "replay/log/log_reader.h"
#include "replay/measure/measure.h"
#include "replay/session/recorder.h"
#include "src/base/result.h"
#include "src/model/transform.h"

/// Two sessions that should be one another's image: a scene and what a transform (a mirror, a shift, other names) makes
/// of it.
namespace tumble::replay {

struct TwinReport {
  std::uint64_t steps = 0;  ///< compared, beside the start
  /// m: the largest distance of a body from the image of its twin, over all states; kNoTwin where a body has none.
  double error = 0;
  std::uint64_t differing = 0;              ///< bodies whose visible state was not the image in every bit, in any state
  std::optional<std::uint64_t> first_step;  ///< after which one differed; none: exact images throughout
};

/// What a body counts that exists on one side only, m: the width of the world, more than any distance in it.
inline constexpr double kNoTwin = 65'536;

/// Compares states of two sessions as they go by.
class TwinMeter {
 public:
  /// transform and ids: what makes the second of the first.
  TwinMeter(const sim::Transform& transform, sim::IdMap ids) : transform_(transform), ids_(std::move(ids)) {}

  /// The states of both after a step.
  void add(std::uint64_t step, const BodyStates& original, const BodyStates& image);

  [[nodiscard]] const TwinReport& report() const { return report_; }

 private:
  void differs(std::uint64_t step, sim::BodyId id, double distance);

  sim::Transform transform_;
  sim::IdMap ids_;
  std::set<sim::BodyId> differing_;
  TwinReport report_;
};

/// Steps a scene and its image side by side, without files: scene.steps steps with the scene's inputs. Errors:
/// create_world's, an input that is refused, a step that fails, a stop asked for by `progress` (kCannotFinish).
Result<TwinReport> run_twins(const sim::SceneDef& scene, const sim::Transform& transform,
                             const Progress& progress = {});

/// Compares the logs of a session and of its image: `record --mirror`, `--permute`, `--shift` wrote the transform into
/// the second one's header. Errors: logs that cannot be read, a first log that is an image itself, a second one that is
/// not of the first one's scene (kBadInput), a stop asked for by `progress` (kCannotFinish).
Result<TwinReport> compare_twins(LogReader& original, LogReader& image, const Progress& progress = {});

/// Puts the error where it belongs: mirror_error for a reflection, order_error for other names, shift_error for a
/// shift, and each of them for a mixture.
void set_twin_error(const sim::Transform& transform, const TwinReport& report, SymmetryMetrics& metrics);

}  // namespace tumble::replay
