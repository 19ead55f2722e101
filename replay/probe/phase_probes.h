#pragma once

#include <cstdint>
#include <string>

#include "tumble/replay/log_reader.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// Takes step k of a log of ours again from the log's own state before it, and writes to `path` the probes of that step
/// (tumble_probe.h): after every phase of every substep the hash of all that the phase wrote, then the state of each
/// moving body and the contacts. Their place is the function of the phase. The simulation is only observed. Errors:
/// Player::at's and Player::step's; kCannotFinish where the file cannot be written.
Status write_phase_probes(LogReader& log, std::uint64_t k, const std::string& path);

}  // namespace tumble::replay
