#pragma once

#include <cstddef>
#include <vector>

#include "src/world/world.h"

namespace tumble::sim {

/// What the size of a part of a world's memory follows.
enum class GrowsWith { kBodies, kPairs, kContacts };

struct MemoryPart {
  const char* name;
  GrowsWith with;
  std::size_t bytes;  ///< that its vectors have room for
};

/// All memory that a world's state and scratch hold; what a step needs beyond it is a few words on the stack.
std::vector<MemoryPart> memory_use(const World& world);

}  // namespace tumble::sim
