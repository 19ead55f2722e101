#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "src/kernels/box_frame.h"
#include "tumble/sim/world_state.h"

namespace tumble::replay {

/// The bodies of a start that lie on much lighter ones than their method bears.
class StartLoads {
 public:
  /// All three must outlive this; boxes: of the bodies, which may still be added.
  StartLoads(const sim::Bodies& bodies, const std::vector<sim::BoxFrame>& boxes, const sim::WorldDef& world)
      : bodies_(bodies), boxes_(boxes), world_(world) {}

  /// Takes two bodies that may touch.
  void look_at(std::size_t i, std::size_t j);

  /// Adds a sentence on the worst pair, if there is one, with the number of the others.
  void add_to(std::vector<std::string>& out) const;

 private:
  [[nodiscard]] double bearable_ratio(std::size_t light) const;
  [[nodiscard]] double thesis_ratio(double substeps) const;
  [[nodiscard]] bool presses(std::size_t heavy, std::size_t light) const;
  [[nodiscard]] std::string remedy() const;

  const sim::Bodies& bodies_;
  const std::vector<sim::BoxFrame>& boxes_;
  const sim::WorldDef& world_;
  std::size_t heavy_ = 0, light_ = 0, count_ = 0;  // the worst pair; the number of all
  double times_ = 0;                               // as heavy
};

}  // namespace tumble::replay
