#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "replay/arrays/npy.h"
#include "tumble/sim/result.h"

namespace tumble::replay {

/// The values of a channel of pairs, a row each, in any order.
struct PairArrays {
  const Array* values = nullptr;  ///< "pair.force", (rows)
  const Array* steps = nullptr;   ///< "step.pair.force": numbers of steps
  const Array* a = nullptr;       ///< "a.pair.force": numbers of bodies, as `id` has them
  const Array* b = nullptr;
  const Array* texts = nullptr;  ///< the values are numbers of its rows; null: they are values
};

/// The steps and bodies of the archive.
struct PairPlaces {
  const Array* steps = nullptr;    ///< numbers of the steps; null: 0, 1, …
  const Array* ids = nullptr;      ///< numbers of the bodies; null: 1, 2, …
  const Array* present = nullptr;  ///< null: all bodies in all steps
  std::size_t step_count = 0, body_count = 0;
  bool named = false;  ///< without ids, bodies have names
};

/// Cells as import_csv() reads them, "7=0.25 9=0.5", by index of the step, then of the first body.
using PairCells = std::vector<std::map<std::size_t, std::string>>;

/// Errors (kBadInput): a missing array or another shape; a step or a body that the archive lacks; a first body
/// that is absent in its step, which has no cell.
Result<PairCells> pair_cells(const PairArrays& pairs, const PairPlaces& places);

}  // namespace tumble::replay
