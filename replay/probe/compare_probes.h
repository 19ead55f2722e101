#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "replay/probe/probe_file.h"

namespace tumble::replay {

/// Two probes of the same name, key and occurrence; indices into the two files.
struct ProbePair {
  std::size_t a = 0;
  std::size_t b = 0;
  std::uint64_t occurrence = 0;  ///< 0-based: the first of this name and key in the step
};

/// The probes of one step in two runs, compared.
struct ProbeComparison {
  std::size_t matched = 0;
  std::size_t different = 0;                ///< matched, with another value
  std::optional<ProbePair> first;           ///< the first of those in the order of run A
  std::optional<ProbePair> first_by_b;      ///< the first of those in the order of run B, where it is another one
  std::vector<ProbePair> same_before;       ///< the last matched probes before `first` in A's order; all are equal
  std::vector<std::size_t> only_a, only_b;  ///< probes whose name, key and occurrence the other run lacks
  std::optional<ProbePair> reordered;       ///< the first matched probe of A that stands elsewhere in B's order
};

/// The number of equal probes kept before the first difference.
inline constexpr std::size_t kSameBeforeMax = 6;

/// Matches probes by name, key and occurrence, and compares the bits of their values.
ProbeComparison compare_probes(const ProbeFile& a, const ProbeFile& b);

}  // namespace tumble::replay
