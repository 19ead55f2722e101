#pragma once

#include <cstdint>
#include <vector>

#include "src/world/scratch.h"
#include "tumble/sim/world_state.h"

namespace tumble::sim {

/// Lists the moving bodies of a layer with their outcomes, and sets the split of masses. Layers may be done at the same
/// time. members_before: manifolds of the layers before. uses: by body, zeros before and after.
void share_layer(const Bodies& bodies, std::uint32_t layer, std::uint32_t members_before,
                 std::vector<std::uint32_t>& uses, ContactBatches& all);

/// Room for the outcomes of so many batches. Rows that are there already keep their values: nobody reads a row that has
/// not been written for the same layer.
inline void make_outcomes(Scratch& scratch, std::size_t batches) {
  if (scratch.outcomes.size() < batches * kLanes * 2) scratch.outcomes.resize(batches * kLanes * 2);
}

}  // namespace tumble::sim
