#pragma once

#include <map>

#include "tumble/replay/extras.h"
#include "tumble/sim/hash.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/result.h"
#include "tumble/sim/scene.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The bodies of a log by their ids, also those that are gone. Pictures, exports and metrics know a body by its id
/// alone, so an id that comes back must be that of the same body.
class KnownBodies {
 public:
  /// Call with each input before it is applied to `bodies`. Errors (kBadInput): the throw of a body whose id was that
  /// of a removed one with another size, mass or material.
  Status see(const sim::Command& input, const sim::Bodies& bodies);

  /// Errors (kBadInput): the body was described before, by another name or shape.
  Status describe(const BodyInfo& info);

 private:
  void remove(const sim::Bodies& bodies, sim::BodyId id);
  [[nodiscard]] Status check(const sim::BoxDef& box) const;

  std::map<sim::BodyId, sim::BoxDef> removed_;
  std::map<sim::BodyId, Hash128> described_;  // of name and shape
};

}  // namespace tumble::replay
