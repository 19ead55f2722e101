#pragma once

#include <string>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::golden {

/// The inputs of a log as text for its engine, the {inputs} of a command line: one JSON object a line. The first line
/// has "tumble_inputs" (the version, 1), "dt" (s, of step 1), "steps" and "axes"; every other line has "step", "kind"
/// and the fields of the input, by step, in the order in which they were applied. A step whose length differs from the
/// one before has a line of kind "set_dt". An input that a recorder got by its name has kind "input", "name", "id" (of
/// its body; none: of the world) and "hex" (its bytes); such inputs follow the others of their step. SI units, z up,
/// right-handed. Errors: a step that cannot be read.
Result<std::string> inputs_text(replay::LogReader& log);

}  // namespace tumble::golden
