#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

#include "tumble/replay/body_table.h"
#include "tumble/replay/step_record.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// A body as a viewer draws it.
struct ViewedBody {
  sim::BodyId id = 0;
  sim::Vec3 size = {0, 0, 0};  ///< edge lengths, m; zeros where no box and no throw read so far defines the body
  double mass = 0;             ///< kg; 0: likewise
  bool is_static = false;
  sim::Texture texture = sim::Texture::kWhite;
  sim::Origin origin;
  [[nodiscard]] bool known() const { return mass > 0; }
};

/// All bodies of a session, each with a row that it keeps: first those of the scene, then thrown ones as they are met.
class ViewedBodies {
 public:
  explicit ViewedBodies(const LogHeader& header);

  /// Adds the bodies that the inputs of a step throw, and the names and shapes that its extras give.
  void add(const std::vector<sim::Command>& inputs, const Extras& extras = {});

  /// The row of a body; a body that nothing defines yet gets one, to be described later.
  std::size_t row_of(sim::BodyId id);

  [[nodiscard]] const std::vector<ViewedBody>& bodies() const { return bodies_; }

  /// Names and shapes by id.
  [[nodiscard]] const BodyTable& infos() const { return infos_; }

  /// Rises with every change of bodies().
  [[nodiscard]] std::uint32_t version() const { return version_; }

 private:
  void define(const sim::BoxDef& box);

  std::vector<ViewedBody> bodies_;
  std::map<sim::BodyId, std::size_t> rows_;
  BodyTable infos_;
  std::uint32_t version_ = 0;
};

}  // namespace tumble::replay
