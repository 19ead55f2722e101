#include "replay/import/engine_header.h"

#include <string>

#include "replay/format/chain.h"

namespace tumble::replay {

Status check_engine(const EngineName& engine) {
  if (engine.name.empty()) return bad_input("engine: found no name, wanted one");
  if (engine.precision_bits != kBinary32Bits && engine.precision_bits != kBinary64Bits) {
    return bad_input("engine: found a precision of " + std::to_string(engine.precision_bits) +
                     " bits, wanted 24 (binary32) or 53 (binary64)");
  }
  return {};
}

// A log of the last steps of a session is a continued log, whose beginning nobody kept.
void begin_at(std::uint64_t step, LogHeader& header, sim::WorldState& state) {
  state.step = step;
  const Hash128 chain = chain_start(sim::state_hash(state.bodies), header.declared.start);
  header.goes_on = {step, "steps that were not kept", sim::continuation_hash(state), chain};
}

}  // namespace tumble::replay
