#pragma once

#include <vector>

#include "src/scenes/table_reader.h"
#include "tumble/sim/scene.h"

namespace tumble::scenes {

/// The steps that inputs may have. An input's `time` is counted in steps of the scene's own dt. `steps_overridden`:
/// --set gave the length of the session, and inputs after its end are left out instead of being errors.
struct InputClock {
  double dt = 0;
  std::uint64_t steps = 0;
  bool steps_overridden = false;
};

/// An input and where it stands, for the checks that need all of them.
struct PendingInput {
  sim::TimedCommand timed;
  Place place;        ///< of its id, or of the table
  bool late = false;  ///< beyond the end of a session that --set shortened: checked, then left out
};

/// One [[input]]; `table` is its 0-based place in the file. A throw without an id has id 0. Finishes the reader.
PendingInput read_input(TableReader& reader, std::uint32_t table, const InputClock& clock,
                        const sim::Material& scene_material);

/// Brings inputs into the order of their steps, file order within one, and reports those that name a body which does
/// not exist at that time, or an id used twice.
std::vector<sim::TimedCommand> check_inputs(std::vector<PendingInput> inputs, const std::vector<sim::BoxDef>& boxes,
                                            Problem& problem);

}  // namespace tumble::scenes
