#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tumble/sim/result.h"

namespace tumble::replay {

/// A place in the source that writes probes.
struct ProbeSite {
  std::string name;
  std::string file;
  std::uint32_t line = 0;
};

/// One value that a step computed.
struct Probe {
  std::uint32_t site = 0;  ///< index into ProbeFile::sites
  std::uint8_t kind = 0;   ///< TUMBLE_PROBE_F64, _U64 or _I64, without TUMBLE_PROBE_OF_PAIR
  bool of_pair = false;
  std::uint64_t a = 0, b = 0;  ///< the key; b is 0 unless of_pair
  std::uint64_t bits = 0;      ///< of the value
};

/// The probes of one step, in the order in which the engine wrote them.
struct ProbeFile {
  std::uint64_t step = 0;
  std::vector<ProbeSite> sites;
  std::vector<Probe> probes;
  std::string cut;  ///< why the file does not hold the step to its end; empty: it does
};

/// Reads a file of tumble_probe.h. A step that was taken twice (a rollback) counts as taken the second time. Errors.
/// kBadInput: no file, no file of probes, a site that was never named, more than kProbesMax probes.
Result<ProbeFile> read_probes(const std::string& path);

/// "0.1", "17": the value of a probe.
std::string value_text(const Probe& probe);
/// "7", "3 and 7".
std::string key_text(const Probe& probe);

}  // namespace tumble::replay
