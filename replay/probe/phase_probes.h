#pragma once

#include <cstdint>
#include <string>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Takes step k of a log of ours again from the log's own state before it, and writes to `path` the probes of that step
/// (tumble_probe.h): after every phase of every substep the state of each moving body, its motion in the solver, the
/// contacts, and last the hash of all that the phase wrote. Their place is the statement that wrote the value
/// (phase_sites.txt), or the function of a phase that does not write it. The simulation is only observed. Errors:
/// Player::at's and Player::step's; kCannotFinish where the file cannot be written.
Status write_phase_probes(LogReader& log, std::uint64_t k, const std::string& path);

}  // namespace tumble::replay
