#pragma once

#include <cstddef>
#include <vector>

#include "tumble/sim/world.h"

namespace tumble::sim {

/// The number that the size of a part of a world's memory grows with.
enum class GrowsWith { kBodies, kPairs, kContacts };

struct MemoryPart {
  const char* name;
  GrowsWith with;
  std::size_t bytes;  ///< capacity of its vectors
};

/// The memory of a world's state and scratch, part by part. A step needs only a few words on the stack besides.
std::vector<MemoryPart> memory_use(const World& world);

}  // namespace tumble::sim
