#pragma once

#include <cstdint>
#include <map>
#include <optional>

#include "replay/log/log_reader.h"
#include "replay/session/player.h"
#include "replay/session/state_source.h"
#include "src/base/hash.h"
#include "src/base/result.h"
#include "src/model/scene.h"
#include "src/render/scene/snapshot.h"

namespace tumble::replay {

/// What a picture shows beside the bodies.
struct PictureOptions {
  bool freezing = false;    ///< frozen bodies in their material, active ones white (the thesis's Fig. 10)
  bool velocities = false;  ///< an arrow from each moving body, as long as it goes in kArrowSeconds
  bool bounds = false;      ///< the bodies' AABBs (the thesis's Fig. 4)
  bool contacts = false;    ///< the contact points of the step, with an arrow along each normal
};
inline constexpr double kArrowSeconds = 0.2;

/// One state of a log as it is to be seen.
struct Picture {
  std::uint64_t step = 0;
  Hash128 state_hash;
  double dt = 0;  ///< s, of the step that led to it; 0 for state 0
  render::Snapshot snapshot;
};

/// Pictures of a log's states: the scene says how its bodies look, where the camera and the light stand, and the throws
/// tell of those that come later.
class PictureSource {
 public:
  /// log must outlive this, and may be read from in between.
  explicit PictureSource(LogReader& log);

  /// State k of first_state() … last_step(). Quick where steps are asked for in ascending order. Errors:
  /// StateSource::read's; a body that no box and no throw of the log explains (kDamaged); with `contacts`, a step that
  /// cannot be replayed.
  Result<Picture> read(std::uint64_t k, const PictureOptions& options = {});

 private:
  Result<const sim::BoxDef*> find_box(sim::BodyId id, std::uint64_t k);
  void add_throws(const std::vector<sim::Command>& inputs);
  Status add_contacts(std::uint64_t k, render::Snapshot& snapshot);

  LogReader* log_;
  StateSource states_;
  std::map<sim::BodyId, sim::BoxDef> boxes_;
  std::uint64_t scanned_ = 0;  // steps whose inputs were looked at for throws
  std::optional<Player> player_;
};

/// Two sessions in one picture, for the eye to find the difference: bodies that are the same to the bit as they are in
/// `ours`; those that differ twice, orange in ours and blue in theirs; those that only one has, likewise.
render::Snapshot overlay(const render::Snapshot& ours, const render::Snapshot& theirs);

}  // namespace tumble::replay
