#pragma once

#include <string>
#include <vector>

#include "tumble/replay/recorder.h"
#include "tumble/sim/ids.h"
#include "tumble/sim/scene.h"

namespace tumble::replay {

/// Inputs made by hand, checked before a session takes them: a session ends at an input that its world refuses.
class LiveInputs {
 public:
  /// Gives every thrown box an id of its own. No id comes twice in the life of this object, also after the removal of
  /// its body and after a return to an earlier state, so that a log's throws define each body once.
  /// Returns the inputs that the next step of `recorder` can take, in their order, and adds to `refused` a line for
  /// each other one.
  std::vector<sim::Command> check(const Recorder& recorder, std::vector<sim::Command> inputs,
                                  std::vector<std::string>& refused);

 private:
  sim::BodyId next_id_ = 0;
};

}  // namespace tumble::replay
