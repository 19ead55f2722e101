#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

#include "replay/format/not_finite.h"
#include "replay/session/state_source.h"
#include "tumble/render/snapshot.h"
#include "tumble/replay/body_table.h"
#include "tumble/replay/log_reader.h"
#include "tumble/replay/player.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// Additions to a picture of the bodies.
struct PictureOptions {
  bool freezing = false;    ///< frozen bodies in their material, active ones white (the thesis's Fig. 10)
  bool velocities = false;  ///< an arrow from each moving body, as long as the body moves in kArrowSeconds
  bool bounds = false;      ///< the bodies' AABBs (the thesis's Fig. 4)
  bool contacts = false;    ///< the contact points of the step, with an arrow along each normal
  std::optional<sim::Camera> camera = {};  ///< instead of the scene's
};
inline constexpr double kArrowSeconds = 0.2;

/// One state of a log, ready to render.
struct Picture {
  std::uint64_t step = 0;
  Hash128 state_hash;
  double dt = 0;                        ///< s, of the step that led to it; 0 for state 0
  std::optional<NotFinite> not_finite;  ///< not drawn; the field is named by the axes of the log
  render::Snapshot snapshot;
};

/// Makes pictures of a log's states. The scene gives the look of its bodies, the camera and the light; throws give the
/// look of bodies that come later.
class PictureSource {
 public:
  /// `log` must outlive this object. Others may read from `log` between two calls.
  explicit PictureSource(LogReader& log);

  /// Bodies of other engines are drawn in their shapes; a shape whose surface is not known as the box around it. Reads
  /// state k of first_state() … last_step(). Quick where steps are read in ascending order. Errors:
  /// StateSource::read's; a body that no box and no throw of the log defines (kDamaged); with `contacts`, a step that
  /// cannot be replayed, or that this build computes otherwise (kCannotFinish).
  Result<Picture> read(std::uint64_t k, const PictureOptions& options = {});

 private:
  Result<const sim::BoxDef*> find_box(sim::BodyId id, std::uint64_t k);
  void add_throws(const StepRecord& step);
  std::shared_ptr<const render::Solid> solid_of(sim::BodyId id);
  Status add_contacts(std::uint64_t k, render::Snapshot& snapshot);

  LogReader* log_;
  StateSource states_;
  std::map<sim::BodyId, sim::BoxDef> boxes_;
  BodyTable infos_;                                                      // their names and shapes
  std::map<const Shape*, std::shared_ptr<const render::Solid>> solids_;  // of the shapes of infos_
  std::uint64_t scanned_ = 0;  // the last step whose inputs were searched for throws
  std::optional<Player> player_;
};

/// Draws two sessions in one picture. A body that is equal to the bit in both looks as in `ours`. A body that differs
/// appears twice, orange as in `ours` and blue as in `theirs`; a body of one session alone has that session's colour.
/// Both snapshots list their boxes by ascending id.
render::Snapshot overlay(const render::Snapshot& ours, const render::Snapshot& theirs);

}  // namespace tumble::replay
